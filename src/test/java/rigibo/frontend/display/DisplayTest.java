package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.lwjgl.glfw.GLFW;
import org.lwjgl.glfw.GLFWMouseButtonCallback;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Real windows with real OpenGL. */
class DisplayTest {

    @TempDir Path folder;

    /** Draws one of everything, and tells what the pointer did. */
    private static final class Everything implements Scene {

        final List<String> heard = new ArrayList<>();
        int turns;
        int keys;

        @Override
        public void keyPressed(Key key) {
            keys++;
        }

        @Override
        public String title() {
            return "Everything";
        }

        @Override
        public void step() {
            turns++;
        }

        @Override
        public void draw(Canvas canvas) {
            canvas.camera(Camera.ofPuzzle());
            for (Skin skin : Skin.values()) {
                for (Canvas.Mood mood : Canvas.Mood.values()) {
                    double x = 1 + skin.ordinal();
                    double y = 1 + 2 * mood.ordinal();
                    canvas.body(Polygon.box(0.8, 0.6), x, y, 0.3, skin, mood);
                    canvas.body(new Circle(0.3), x, y + 1, 0.3, skin, mood);
                }
            }
            canvas.particle(4, 9, 0.1, 0.5, Color.RIGIBO);
            canvas.panel(10, 10, 200, 60, 8, Color.PANEL);
            canvas.frame(10, 10, 200, 60, 8, Color.BRASS);
            canvas.text("words", 20, 40, 20, Canvas.Font.WORDS, Canvas.Align.LEFT, Color.TEXT);
            canvas.ring(400, 40, 20, 4, 0.7, Color.GOOD);
            canvas.disc(460, 40, 10, Color.BAD);
            canvas.line(500, 20, 560, 60, 3, Color.TEXT);
            canvas.graph(new double[] {0, 1, 0.5}, 3, 600, 20, 100, 40, Color.GOOD);
        }

        @Override
        public void pointerPressed(PointerButton button, double x, double y) {
            heard.add(button + " " + Math.round(x) + " " + Math.round(y));
        }
    }

    @Test
    void drawsEverythingWithoutAComplaint() {
        Everything scene = new Everything();
        Display display = display(scene);
        Path picture = folder.resolve("everything.png");
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void afterDrawing(Display of, Scene shown) {
                        if (scene.turns == 3) {
                            of.picture(picture);
                            of.quit();
                        }
                    }
                });
        display.run(null);
        assertThat(display.troubles()).isEmpty();
        // An empty picture of 720 × 800 packs into a few kB; one full of textures does not.
        assertThat(picture).satisfies(file -> assertThat(Files.size(file)).isGreaterThan(40_000));
    }

    /** A button that is still held in a new window, whose first pictures are dark. */
    @Test
    void nothingIsPressedBeforeAPictureCanBeSeen() {
        Everything scene = new Everything();
        Display display = display(scene);
        List<Integer> turns = new ArrayList<>();
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void beforeTurn(Display of, Scene shown) {
                        of.window().gamepad(GamepadButton.X);
                        turns.add(scene.keys);
                        if (scene.turns > 2 * Curtain.FRAMES) {
                            of.quit();
                        }
                    }
                });
        display.run(null);
        assertThat(turns.get(1)).as("after a picture that is dark").isZero();
        assertThat(scene.keys).isPositive();
    }

    @Test
    void bringsAClickToTheSceneInLogicalPixels() {
        Everything scene = new Everything();
        Display display = display(scene);
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void beforeTurn(Display of, Scene shown) {
                        of.input().cursor(360, 400);
                        of.input().mouseButton(GLFW.GLFW_MOUSE_BUTTON_LEFT, GLFW.GLFW_PRESS);
                        of.quit();
                    }
                });
        display.run(null);
        assertThat(scene.heard).containsExactly("LEFT 360 400");
    }

    @Test
    void showsWhatIsMadeOfDroppedFiles() {
        List<String> made = new ArrayList<>();
        List<Scene> shown = new ArrayList<>();
        Display display = display(new Everything());
        Everything ofFiles = new Everything();
        display.opensFilesBy(
                (director, files) -> {
                    files.forEach(file -> made.add(file.toString()));
                    return ofFiles;
                });
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void beforeTurn(Display of, Scene scene) {
                        shown.add(scene);
                        if (scene == ofFiles) {
                            of.quit();
                        } else if (shown.size() == 1) {
                            of.dropped(List.of(Path.of("a.json"), Path.of("b.replay.json")));
                        }
                    }
                });
        display.run(null);
        assertThat(made).containsExactly("a.json", "b.replay.json");
        assertThat(shown.get(shown.size() - 1)).isSameAs(ofFiles);
    }

    @Test
    void aClickCountsOnlyOnceThereIsAPicture() {
        Everything scene = new Everything();
        Display display = display(scene);
        List<Integer> heard = new ArrayList<>();
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void beforeTurn(Display of, Scene shown) {
                        clickAsGlfwDoes();
                        heard.add(scene.heard.size());
                        if (heard.size() == Curtain.FRAMES) {
                            of.quit();
                        }
                    }
                });
        display.run(null);
        assertThat(heard.subList(0, Curtain.FRAMES / 2)).as("pictures are dark").containsOnly(0);
        assertThat(heard.get(Curtain.FRAMES - 1)).isPositive();
    }

    private static void clickAsGlfwDoes() {
        long window = GLFW.glfwGetCurrentContext();
        GLFWMouseButtonCallback callback = GLFW.glfwSetMouseButtonCallback(window, null);
        GLFW.glfwSetMouseButtonCallback(window, callback);
        callback.invoke(window, GLFW.GLFW_MOUSE_BUTTON_LEFT, GLFW.GLFW_PRESS, 0);
    }

    /** The scene that a code makes replaces the one in which it was pasted. */
    @Test
    void pastesWhatWasCopiedAndComplainsOfNothing() {
        List<String> pasted = new ArrayList<>();
        Display display = display(new Everything());
        Everything ofCode = new Everything();
        display.opensCodesBy(
                (director, text) -> {
                    pasted.add(text);
                    return text.isEmpty() ? Optional.empty() : Optional.of(ofCode);
                });
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void beforeTurn(Display of, Scene scene) {
                        if (scene == ofCode) {
                            of.quit();
                        } else if (pasted.isEmpty()) {
                            of.copy("");
                            of.paste();
                            of.copy("RIGIBO-Größe");
                        } else {
                            of.input().modifiers(GLFW.GLFW_MOD_CONTROL);
                            of.input().key(GLFW.GLFW_KEY_V, GLFW.GLFW_PRESS);
                        }
                    }
                });
        display.run(null);
        assertThat(pasted).containsExactly("", "RIGIBO-Größe");
        assertThat(display.troubles()).isEmpty();
    }

    @Test
    void destroysEachWindowBeforeTheNextOpens() {
        List<Everything> shown = new ArrayList<>();
        Display display = display(new Everything());
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void beforeTurn(Display of, Scene scene) {
                        shown.add((Everything) scene);
                        if (shown.size() == 5) {
                            of.quit();
                        } else {
                            of.show(new Everything());
                        }
                    }
                });
        display.run(null);
        assertThat(shown).doesNotHaveDuplicates().hasSize(5);
        assertThat(display.troubles()).isEmpty();
    }

    @Test
    void leavesASceneForTheMenuByEscAndTheMenuForGood() {
        List<String> titles = new ArrayList<>();
        Everything menu = new Everything();
        Display display = display(menu);
        display.accompany(
                new Display.Companion() {
                    @Override
                    public void beforeTurn(Display of, Scene scene) {
                        titles.add(scene == menu ? "menu" : "scene");
                        of.input().key(GLFW.GLFW_KEY_ESCAPE, GLFW.GLFW_PRESS);
                    }
                });
        display.run(director -> new Everything());
        assertThat(titles).containsExactly("scene", "menu");
    }

    /** A picture that takes 60 ms of a fake time holds up four steps, after what came in before. */
    @Test
    void aLatePictureIsFollowedByTheStepsThatAreDueAfterTheInputInItsOrder() {
        List<String> told = new ArrayList<>();
        long[] now = new long[1];
        Scene scene = new Slow(told, () -> now[0] += 60_000_000);
        FrameClock clock = new FrameClock(() -> now[0] += 1000, nanos -> now[0] += nanos);
        Display display = new Display((Director director) -> scene, clock);
        display.accompany(
                new Display.Companion() {

                    private int turns;

                    @Override
                    public int mostSteps() {
                        return FrameClock.MOST_STEPS;
                    }

                    @Override
                    public void beforeTurn(Display of, Scene shown) {
                        if (turns == 0) {
                            // Without a graphics card, pictures were drawn that nobody saw.
                            told.clear();
                        }
                        of.input().key(GLFW.GLFW_KEY_A, GLFW.GLFW_PRESS);
                        of.input().key(GLFW.GLFW_KEY_B, GLFW.GLFW_PRESS);
                        if (++turns == 3) {
                            of.quit();
                        }
                    }
                });
        display.run(null);
        // Steps are due 16.7 ms apart: 0; 16.7, 33.3 and 50 at 60 ms; quitting needs no more steps.
        assertThat(String.join(" ", told))
                .isEqualTo("A B step picture A B step step step picture A B step picture");
    }

    /** Tells what happens to it, and takes its time to draw. */
    private record Slow(List<String> told, Runnable draws) implements Scene {

        @Override
        public String title() {
            return "Slow";
        }

        @Override
        public void step() {
            told.add("step");
        }

        @Override
        public void keyPressed(Key key) {
            told.add(key.name());
        }

        @Override
        public void draw(Canvas canvas) {
            told.add("picture");
            draws.run();
        }
    }

    private static Display display(Scene menu) {
        return new Display((Director director) -> menu, false);
    }
}
