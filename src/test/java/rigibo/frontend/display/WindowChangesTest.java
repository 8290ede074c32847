package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import rigibo.backend.ChildJvm;
import rigibo.backend.geometry.Circle;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.io.IOException;
import java.util.List;

/** One window after the other, in a JVM of its own, since it looks at the whole heap. */
@Execution(ExecutionMode.CONCURRENT)
class WindowChangesTest {

    private static final int CHANGES = 50;

    /** Growth of the heap that counts as a leak, MB; the textures of one window are as large. */
    private static final double MOST_GROWTH = 4;

    /** Draws a little and asks for the next, until as many were shown. */
    private record Passing(Director director, int left) implements Scene {

        @Override
        public String title() {
            return left + " to go";
        }

        @Override
        public void step() {
            if (left > 0) {
                director.show(new Passing(director, left - 1));
            } else {
                director.quit();
            }
        }

        @Override
        public void draw(Canvas canvas) {
            canvas.body(new Circle(1), 4, 4, 0, Skin.BALL, Canvas.Mood.PLAIN);
        }
    }

    private static double heap() {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return (runtime.totalMemory() - runtime.freeMemory()) / 1e6;
    }

    private static Display afterChanges(int changes) {
        Display display = new Display(director -> new Passing(director, changes), false);
        display.run(null);
        return display;
    }

    /** Prints by how many MB the heap grew. */
    public static void main(String[] arguments) {
        // The first ones fill what is filled once.
        afterChanges(CHANGES / 10);
        double before = heap();
        Display display = afterChanges(CHANGES);
        if (!display.troubles().isEmpty()) {
            throw new IllegalStateException(display.troubles().toString());
        }
        System.out.println(heap() - before);
    }

    @Test
    void fiftyWindowsLeaveNothingBehind() throws IOException, InterruptedException {
        String printed =
                ChildJvm.output(
                        ChildJvm.own(),
                        List.of("-ea", "-XX:+UseSerialGC"),
                        WindowChangesTest.class);
        // Graphics drivers may print warnings before.
        String last = printed.substring(printed.lastIndexOf('\n') + 1);
        assertThat(Double.parseDouble(last)).isLessThan(MOST_GROWTH);
    }
}
