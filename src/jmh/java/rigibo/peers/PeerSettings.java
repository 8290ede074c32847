package rigibo.peers;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.Setting;

import java.util.List;

/**
 * How peers are run. Thresholds that hold for a whole engine, such as the 1 m/s below which none of
 * them lets anything bounce, stay as they come: that is what its users get.
 */
public final class PeerSettings {

    private static final int FOURFOLD = 4;

    /** As they come, at the step of the game. */
    public static final Setting DEFAULT = Setting.of("default", Line.PEERS);

    /**
     * Their manuals know two ways to less error, shorter steps for motion and more iterations for
     * contacts. Neither does the other's work, so that the finer setting takes both, fourfold.
     */
    public static final Setting FINER =
            new Setting("finer", Line.PEERS, 0, Setting.USUAL_STEP / FOURFOLD);

    private PeerSettings() {}

    /** Both, as they come first. */
    public static List<Setting> all() {
        return List.of(DEFAULT, FINER);
    }

    /** How many iterations a setting makes of those that an engine comes with. */
    public static int iterations(Setting setting, int asTheyCome) {
        return setting.equals(FINER) ? FOURFOLD * asTheyCome : asTheyCome;
    }
}
