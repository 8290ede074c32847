package rigibo.peers.dyn4j;

import org.dyn4j.Version;

import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.peers.PeerSettings;

import java.util.List;

/** dyn4j. */
public final class Dyn4jEngine implements Engine {

    @Override
    public String name() {
        return "dyn4j " + Version.getVersion();
    }

    @Override
    public List<Setting> settings() {
        return PeerSettings.all();
    }

    @Override
    public World world(Effects effects, Setting setting) {
        return new Dyn4jWorld(effects, setting);
    }
}
