// C++: an effect that is owned, sources in vectors, and errors as exceptions. Sparks fly around in a window. Escape ends it.
#include <energywave.h>
#include <GLFW/glfw3.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

namespace
{

void check(ew_result result, const ew_error &error)
{
    if (result != EW_OK) throw std::runtime_error(error.text);
}

struct effect_deleter {
    void operator()(ew_effect *effect) const
    {
        ew_destroy_effect(effect);
    }
};

class Glow
{
  public:
    Glow()
    {
        ew_effect_desc desc = {};
        desc.get_proc_address = [](void *, const char *name) -> ew_gl_function { return glfwGetProcAddress(name); };
        ew_effect *created = nullptr;
        ew_error error;
        check(ew_create_effect(&desc, &created, &error), error);
        effect.reset(created);
    }

    void draw(const std::vector<ew_point> &points, const ew_frame_desc &frame)
    {
        ew_sources_desc sources = {};
        sources.points = points.data();
        sources.point_count = points.size();
        ew_error error;
        check(ew_set_sources(effect.get(), &sources, &error), error);
        check(ew_draw(effect.get(), &frame, &error), error);
    }

  private:
    std::unique_ptr<ew_effect, effect_deleter> effect;
};

std::vector<ew_point> make_sparks(double seconds)
{
    std::vector<ew_point> sparks(6);
    for (std::size_t i = 0; i < sparks.size(); ++i) {
        const double angle = 1.5 * seconds + static_cast<double>(i);
        ew_point &spark = sparks[i]; // its members are 0, like those of `ew_point spark = {}`
        spark.position[0] = 2 * std::cos(angle);
        spark.position[1] = std::sin(1.7 * angle);
        spark.position[2] = 2 * std::sin(angle);
        spark.color[0] = 1;
        spark.color[1] = 0.4;
        spark.color[2] = 0.1;
        spark.core = 0.1;
        spark.reach = 1.5;
        spark.brightness = 2;
        spark.sharpness = 2;
    }
    return sparks;
}

void run(GLFWwindow *window)
{
    Glow glow;
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_ESCAPE) != GLFW_PRESS) {
        ew_frame_desc frame = EW_FRAME_DEFAULTS;
        glfwGetFramebufferSize(window, &frame.viewport_width, &frame.viewport_height);
        frame.view[14] = -4;
        frame.projection[0] = frame.viewport_height / std::fmax(frame.viewport_width, 1);
        frame.output = EW_OUTPUT_SOFT;
        frame.dither = 1;
        glClear(GL_COLOR_BUFFER_BIT);
        if (frame.viewport_width > 0) glow.draw(make_sparks(glfwGetTime()), frame);
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
}

} // namespace

int main()
{
    int status = 1;
    if (!glfwInit()) return status;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    if (GLFWwindow *window = glfwCreateWindow(960, 540, "EnergyWave", nullptr, nullptr)) {
        glfwMakeContextCurrent(window);
        try {
            run(window);
            status = 0;
        } catch (const std::exception &error) {
            std::fprintf(stderr, "cxx: %s\n", error.what());
        }
    }
    glfwTerminate();
    return status;
}
