package rigibo.peers;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.Setting;

import java.util.List;

/**
 * The settings of peers. Thresholds of a whole engine, such as the 1 m/s below which none of them
 * lets bodies bounce, keep their defaults, as for their users.
 */
public final class PeerSettings {

    private static final int FOURFOLD = 4;

    /** The default setting, at the step of the game. */
    public static final Setting DEFAULT = Setting.of("default", Line.PEERS);

    /**
     * A finer setting. Their manuals reduce errors by shorter steps for motion and more iterations
     * for contacts. Neither replaces the other, so this setting uses both, fourfold.
     */
    public static final Setting FINER =
            new Setting("finer", Line.PEERS, 0, Setting.USUAL_STEP / FOURFOLD);

    private PeerSettings() {}

    /** Both settings, the default first. */
    public static List<Setting> all() {
        return List.of(DEFAULT, FINER);
    }

    /** The number of iterations of a setting, given the engine's default. */
    public static int iterations(Setting setting, int asTheyCome) {
        return setting.equals(FINER) ? FOURFOLD * asTheyCome : asTheyCome;
    }
}
