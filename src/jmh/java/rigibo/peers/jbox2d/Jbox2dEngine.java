package rigibo.peers.jbox2d;

import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.peers.PeerSettings;

import java.util.List;

/** JBox2D. */
public final class Jbox2dEngine implements Engine {

    @Override
    public String name() {
        // The library does not state its version.
        return "JBox2D 2.2.1.1";
    }

    @Override
    public List<Setting> settings() {
        return PeerSettings.all();
    }

    @Override
    public World world(Effects effects, Setting setting) {
        return new Jbox2dWorld(effects, setting);
    }
}
