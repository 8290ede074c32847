package rigibo.frontend.puzzle.hud;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Wind;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.effects.SceneEffects;

import java.util.List;

/** The effects bar's view of the running game, with words general enough for every level. */
final class LevelEffects implements SceneEffects {

    /** Wind speed, m/s: boxes are heavy, and only a storm moves them. */
    private static final double STORM = 30;

    private final Level level;
    private final Session session;
    private final Words words;

    LevelEffects(Level level, Session session, Words words) {
        this.level = level;
        this.words = words;
        this.session = session;
    }

    @Override
    public Words words() {
        return words;
    }

    @Override
    public Pool pool() {
        return session.game().pool();
    }

    @Override
    public Effects calledFor() {
        return level.world().effects();
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new RollingResistance(), words.of("puzzle.effects.rolling")),
                new EffectReason(new Wind(STORM, 0), words.of("puzzle.effects.wind")));
    }

    @Override
    public void experiment(Effects effects) {
        session.game().experiment(effects);
    }

    @Override
    public String marking() {
        return session.game().isExperiment() ? words.of("puzzle.effects.marking") : "";
    }
}
