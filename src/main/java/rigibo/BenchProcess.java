package rigibo;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.lab.bench.probe.BenchProbe;
import rigibo.lab.bench.probe.Sample;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.bench.scene.Pace;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Fields;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The process in which the bench times a scene. It is outside the laboratory because one of the
 * scenes is a level, which the laboratory cannot read.
 */
final class BenchProcess {

    private static final String LEVEL = "level";

    private BenchProcess() {}

    /**
     * Measures, and prints the result.
     *
     * @param arguments names of the scene and of the engine, and the pace as text
     */
    public static void main(String[] arguments) {
        String name = arguments[0];
        BenchScene scene = name.equals(LEVEL) ? level() : BenchScenes.named(name);
        Engine engine = Engines.named(arguments[1]);
        Pace pace = Pace.parse(arguments[2]);
        Sample sample = BenchProbe.measure(engine, scene.scene().get(), pace);
        System.out.println(BenchProbe.MARK + Fields.line(sample));
    }

    /** The first level of the game without a player, so that nothing in it moves. */
    static BenchScene level() {
        return new BenchScene(
                LEVEL,
                "the first level of the game, nobody playing",
                new Pace(1, 120, 600),
                BenchProcess::firstLevel);
    }

    private static Scene firstLevel() {
        Path file = LevelShelf.files().get(0);
        Level level =
                new LevelLoader()
                        .load(file)
                        .level()
                        .orElseThrow(() -> new IllegalStateException(file + " cannot be read"));
        List<BodyDefinition> bodies = new ArrayList<>();
        bodies.add(level.platform().definition());
        level.bodies().stream().map(LevelBody::definition).forEach(bodies::add);
        level.balls().forEach(ball -> bodies.add(ball.definition()));
        return new Scene(awake(level.world().effects()), bodies);
    }

    /** The effects without sleep, which would leave nothing to time. */
    private static Effects awake(Effects effects) {
        return effects.declares(Sleep.class) ? effects.without(Sleep.class) : effects;
    }
}
