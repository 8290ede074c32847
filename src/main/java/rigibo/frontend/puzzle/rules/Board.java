package rigibo.frontend.puzzle.rules;

import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Magnet;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Source;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.World;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The bodies of a level in a pool.
 *
 * @param world its bounds
 * @param pool the bodies, in the order platform, level's bodies, balls
 * @param platform where the balls must stay
 * @param pieces the level's bodies in the file's order, including deleted ones
 * @param links the joints on which clicks act, in the file's order
 * @param balls the balls; last in the pool, so that a click on one finds it
 * @param sources the fans and magnets among the pieces
 */
record Board(
        World world,
        Pool pool,
        RigidBody platform,
        List<Piece> pieces,
        List<Link> links,
        List<RigidBody> balls,
        Sources sources) {

    /**
     * Distance outside the world at which a body is removed, m; the ball is judged at the edge
     * itself.
     */
    private static final double STRAY = 3;

    /** Distance from a joint within which a click finds it, m: about ten pixels. */
    private static final double REACH = 0.13;

    static Board of(Level level, Accuracy accuracy) {
        Effects effects = level.world().effects();
        Pool pool = new Pool(effects, accuracy);
        RigidBody platform = pool.add(level.platform().definition());
        List<Piece> pieces =
                level.bodies().stream()
                        .map(
                                body ->
                                        new Piece(
                                                body,
                                                add(pool, body.definition(), body.substance())))
                        .toList();
        List<RigidBody> balls =
                level.balls().stream()
                        .map(ball -> add(pool, ball.definition(), ball.substance()))
                        .toList();
        Sources sources = new Sources(pieces);
        if (sources.areAny()) {
            pool.effects(sources.in(effects));
        }
        List<Link> links = new ArrayList<>();
        Board board = new Board(level.world(), pool, platform, pieces, links, balls, sources);
        for (LevelJoint joint : level.joints()) {
            Joint joined = pool.join(joint.definition(board.end(joint.a()), board.end(joint.b())));
            if (joint.verb().isPresent()) {
                links.add(new Link(joint, joined));
            }
        }
        return board;
    }

    /**
     * Adds a body. One that magnets pull is in a category of its own besides the usual one, so that
     * it collides like all others.
     */
    private static RigidBody add(Pool pool, BodyDefinition made, Substance substance) {
        boolean isPulled = substance == Substance.IRON && pool.effects().declares(Magnet.class);
        int category = Filter.ALL.category() | Source.IRON;
        return pool.add(isPulled ? made.filter(Filter.ALL.category(category)) : made);
    }

    /** The body that a joint names; ids have precedence over the names of balls and platform. */
    private RigidBody end(String name) {
        return piece(name)
                .map(Piece::body)
                .or(() -> LevelJoint.ball(name).map(balls::get))
                .orElse(platform);
    }

    /**
     * The target of a click at a point of the world, clickable or not. A joint is drawn over the
     * bodies and is found near its line. But where a rope crosses a clickable body, the body is
     * meant, since the rope can be clicked elsewhere.
     */
    Optional<Target> targetAt(double x, double y) {
        Optional<Piece> piece = pieceAt(x, y);
        boolean isTaken = piece.filter(Piece::isClickable).isPresent();
        Optional<Target> link =
                links.stream()
                        .filter(Link::isClickable)
                        .filter(each -> !(isTaken && each.isRope()))
                        .filter(each -> each.distance(x, y) <= REACH)
                        .min(Comparator.comparingDouble(each -> each.distance(x, y)))
                        .map(each -> each);
        return link.or(() -> piece);
    }

    Optional<Piece> pieceAt(double x, double y) {
        return pool.bodyAt(x, y).flatMap(this::piece);
    }

    Optional<Piece> piece(String id) {
        return pieces.stream().filter(piece -> piece.definition().id().equals(id)).findFirst();
    }

    Optional<Piece> piece(RigidBody body) {
        return pieces.stream().filter(piece -> piece.body() == body).findFirst();
    }

    /** All bodies and joints with an id: the pieces, then the links. */
    List<Target> targets() {
        List<Target> targets = new ArrayList<>(pieces);
        targets.addAll(links);
        return targets;
    }

    Optional<Target> target(String id) {
        return targets().stream().filter(target -> target.id().equals(id)).findFirst();
    }

    boolean hasClickable() {
        return targets().stream().anyMatch(Target::isClickable);
    }

    /** Whether every ball touches the platform now. */
    boolean ballsAreOnPlatform() {
        return balls.stream().allMatch(ball -> pool.touching(ball, platform));
    }

    /** Whether one of the balls is lost. */
    boolean ballHasLeft() {
        return balls.stream().anyMatch(this::hasLeft);
    }

    /**
     * Whether a body of the level that was not deleted is out of sight, below or beside the world.
     */
    boolean hasFallen(Piece piece) {
        RigidBody body = piece.body();
        return body.isAlive() && isOutside(body, Math.min(body.shape().boundingRadius(), STRAY));
    }

    /**
     * Whether a ball is out of the world: a ball above it may come back, one below or beside it
     * cannot.
     */
    private boolean hasLeft(RigidBody ball) {
        double radius = ball.shape().boundingRadius();
        return isOutside(ball, radius) || ball.y() > 2 * world.height() + radius;
    }

    /**
     * Removes bodies that fell so far that they no longer matter; otherwise the world would never
     * rest.
     */
    void forgetStrays() {
        for (Piece piece : pieces) {
            if (piece.body().isAlive() && isOutside(piece.body(), STRAY)) {
                pool.remove(piece.body());
            }
        }
    }

    private boolean isOutside(RigidBody body, double margin) {
        return body.x() < -margin || body.x() > world.width() + margin || body.y() < -margin;
    }
}
