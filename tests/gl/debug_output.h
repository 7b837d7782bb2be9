/* What GL has to say: KHR_debug messages of medium severity and above. */
#ifndef TEST_DEBUG_OUTPUT_H
#define TEST_DEBUG_OUTPUT_H

/* Listens to the current context, if it supports that. Prints the messages, and counts those of all contexts. */
void debug_output_watch(void);

/* Between these two calls messages are expected: they are neither printed nor counted. */
void debug_output_pause(void);
void debug_output_resume(void);

int debug_output_count(void);

#endif
