package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.backend.setup.Accuracy;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Work;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;

class BenchCommandTest {

    @TempDir Path directory;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... more) {
        String[] arguments = {
            "bench",
            "--scenes",
            "level",
            "--engines",
            "rigibo",
            "--rounds",
            "1",
            "--steps",
            "3",
            "--out",
            directory.toString(),
            more[0],
            more[1]
        };
        return Main.run(new PrintWriter(out), new PrintWriter(err), arguments);
    }

    @Test
    void measuresASceneInAProcessOfItsOwnAndKeepsWhatItFound() throws IOException {
        Path csv = directory.resolve("bench.csv");
        assertThat(run("--csv", csv.toString())).as(err.toString()).isZero();
        assertThat(out.toString()).contains("level: the first level", "RigiBo");
        assertThat(Files.readAllLines(csv)).hasSize(2);
        Path page = directory.resolve("page.md");
        Files.writeString(page, "# By hand\n\n## What was measured\n\nbefore\n");
        assertThat(run("--markdown", page.toString())).isZero();
        assertThat(err.toString()).contains("1 runs to make", "0 runs to make");
        assertThat(Files.readString(page))
                .startsWith("# By hand\n\n## What was measured\n\nMeasured on ")
                .contains("### level", "By `./rigibo bench --scenes level")
                .doesNotContain("before");
    }

    @Test
    void movingScenesAreTimedAtThePresetsAskedFor() {
        assertThat(move("GAME")).as(err.toString()).isZero();
        assertThat(out.toString()).contains("rain-boxes-10", "GAME").doesNotContain("DRAFT");
        assertThat(move("GAMES")).isEqualTo(2);
        assertThat(err.toString()).contains("--preset", "GAMES", "DRAFT");
    }

    private int move(String preset) {
        String scene = "bench --engines rigibo --moving rain-boxes-10 --steps 3 --runs 1";
        String all = scene + " --out " + directory + " --preset " + preset;
        return Main.run(new PrintWriter(out), new PrintWriter(err), all.split(" "));
    }

    @Test
    void workersAreComparedWithRehearsedOnes() {
        assertThat(share("--workers 1 --rehearse 2,4")).as(err.toString()).isZero();
        assertThat(out.toString()).contains("2, computed", "4, computed", "efficiency");
        assertThat(share("--rehearse 2")).isEqualTo(2);
        assertThat(err.toString()).contains("--rehearse needs --workers");
        assertThat(share("--workers 1 --rehearse 1")).isEqualTo(2);
        assertThat(err.toString()).contains("--rehearse", "2", "64");
    }

    private int share(String crews) {
        String scene = "bench --moving rain-boxes-10 --steps 3 --runs 1 ";
        return Main.run(new PrintWriter(out), new PrintWriter(err), (scene + crews).split(" "));
    }

    /**
     * Each storey stands with two legs and carries a beam on them, two contacts each, and the ball
     * lies on the upper beam: 9 that carry, which nothing else comes near.
     */
    @Test
    void levelHasTheContactsThatCarryIt() {
        Scene scene = BenchProcess.level().scene().get();
        assertThat(scene.dynamic()).isEqualTo(7);
        try (World world = RigiBoEngine.world(scene.effects(), Accuracy.GAME)) {
            scene.bodies().forEach(world::add);
            for (int i = 0; i < 60; i++) {
                world.step(Scene.STEP);
            }
            Work work = world.lastStep();
            assertThat(work.contacts()).isEqualTo(9);
            assertThat(work.impacts()).isZero();
        }
    }
}
