// What the page says to its user.
import { at } from './controls.mjs';

export function say(text, isGood = false) {
    at('message-text').textContent = text;
    at('message').classList.toggle('good', isGood);
    at('message').hidden = !text;
}
