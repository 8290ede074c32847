package rigibo.lab.bench;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Effects;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

import java.nio.file.Path;
import java.util.List;

class InquiryTest {

    private record Named(String name) implements Engine {
        @Override
        public List<Setting> settings() {
            return List.of();
        }

        @Override
        public World world(Effects effects, Setting setting) {
            throw new UnsupportedOperationException("worlds");
        }
    }

    private static final List<Engine> ENGINES = List.of(new RigiBoEngine(), new Named("Peer 1.0"));

    private static List<String> asked(List<BenchScene> scenes, int rounds) {
        return new Inquiry(scenes, ENGINES, rounds, Path.of("out"))
                .tasks().stream()
                        .map(task -> task.scene().name() + " " + task.engine() + " " + task.round())
                        .toList();
    }

    @Test
    void enginesTakeTurnsInEveryRound() {
        List<BenchScene> scenes = List.of(BenchScenes.named("pyramid"), BenchScenes.named("free"));
        assertThat(asked(scenes, 2))
                .containsExactly(
                        "pyramid RigiBo 1",
                        "pyramid Peer 1.0 1",
                        "free RigiBo 1",
                        "free Peer 1.0 1",
                        "pyramid RigiBo 2",
                        "pyramid Peer 1.0 2",
                        "free RigiBo 2",
                        "free Peer 1.0 2");
    }

    @Test
    void sweepIsGoneThroughOnceAndItsLargestSizesByOursAlone() {
        assertThat(asked(BenchScenes.sweep(), 3))
                .contains("flood-of-10000 Peer 1.0 1", "flood-of-50000 RigiBo 1")
                .doesNotContain("flood-of-50000 Peer 1.0 1", "flood-of-100 RigiBo 2");
    }

    @Test
    void engineIsAskedForWithoutItsVersion() {
        assertThat(Inquiry.shortName(new Named("JBox2D 2.2.1.1"))).isEqualTo("jbox2d");
    }
}
