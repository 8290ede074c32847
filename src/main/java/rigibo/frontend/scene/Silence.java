package rigibo.frontend.scene;

/** No sound at all: where there is no device, and where nobody listens. */
public final class Silence implements Sounds {

    @Override
    public void knock(Skin skin, double size, double impulse) {}

    @Override
    public void roll(double speed) {}

    @Override
    public void pop() {}

    @Override
    public void refuse() {}

    @Override
    public void tick(double held) {}

    @Override
    public void chord() {}

    @Override
    public void fail() {}

    @Override
    public void press() {}
}
