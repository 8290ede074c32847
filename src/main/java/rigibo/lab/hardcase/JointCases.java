package rigibo.lab.hardcase;

import rigibo.lab.bench.scene.Assemblies;

import java.util.List;

/** Cases of joints, J1 to J17. */
final class JointCases {

    private static final String AWAKE =
            "At EXACT a hundred of them, which `--full` asks for, are still awake after 15 s.";

    private static final String DRIFT =
            "Crowds of joints beyond the budget of elimination are solved in passes, and their"
                    + " joints drift.";

    private static final String SAG =
            "A row as long as its span sags by the square root of the gaps in its hinges."
                    + " Closing them by micrometres raises the row by millimetres, which adds"
                    + " energy.";

    private JointCases() {}

    /** Cases that keep every limit at GAME and at EXACT. */
    static List<HardCase> held() {
        CaseList list = new CaseList();
        list.fromGame(
                "J1", "a pendulum swings at its period and keeps its energy", Swings::pendulums);
        list.fromGame(
                "J1/fast",
                "what turns by radians in a step keeps its energy and its rate",
                FastTurns::spin);
        list.fromGame(
                "J2", "a box swings on a hinge at its period and keeps its energy", Swings::boxes);
        list.fromGame(
                "J3",
                "a double pendulum keeps its energy and goes its way",
                Swings::doublePendulums);
        list.fromGame(
                "J4",
                "a chain that is laid in its catenary stays there",
                HangingChains::catenaries);
        list.fromGame(
                "J5", "light links carry ten thousand times their mass", HangingChains::heavyBobs);
        list.fromGame("J5/lines", "so do beads on rods and ropes", HangingChains::heavyBobsOnLines);
        list.add(
                "J5/beyond",
                "whatever hangs a weight of a million times its own mass stays in one piece",
                HangingChains::heaviestBobs);
        list.fromGame("J7", "mechanisms move as their geometry says", Mechanisms::run);
        list.fromGame(
                "J13",
                "a car's wheels carry the loads of statics, and it climbs if they grip",
                HillCar::run);
        list.fromGame(
                "J8",
                "springs swing at their period, decay, and bear their load",
                SpringJoints::run);
        list.fromGame(
                "J9",
                "a motor drives up to its speed, and its work is the energy gained",
                DrivenJoints::motors);
        list.fromGame(
                "J10",
                "a body that reaches the limit of its joint stops, or rebounds with e² of its"
                        + " energy",
                DrivenJoints::limits);
        list.fromGame("J14", "a joint breaks at its load", DrivenJoints::breaks);
        list.fromGame(
                "J6",
                "in a cradle on rods the last disc rises as high as the first",
                JointImpacts::cradles);
        list.fromGame(
                "J11",
                "a rope that goes taut stops its ends along it, and holds a bob that turns on it",
                JointImpacts::ropes);
        list.fromGame(
                "J17",
                "an impact on a jointed body moves all bodies joined to it",
                JointImpacts::strikes);
        list.fromGame(
                "J17/blows",
                "what a bullet has set turning about a joint keeps its energy",
                FastTurns::strike);
        list.fromGame(
                "J16",
                "joined bodies obey the laws of order, mirror, scale, frame and strangers",
                JointLaws::run);
        return list.all();
    }

    /** Cases that do not yet keep every limit. */
    static List<HardCase> open() {
        CaseList list = new CaseList();
        list.fromGame(
                        "J15/ragdolls",
                        "ragdolls that fall on each other come to rest in one piece",
                        new JointCrowd(2, 100, true, Assemblies::ragdolls))
                .finding(AWAKE);
        list.fromGame(
                        "J15/grid",
                        "a net of hinges hangs together",
                        new JointCrowd(8, 30, false, Assemblies::grid))
                .finding(DRIFT);
        list.fromGame(
                        "J15/doors",
                        "sprung doors fall shut and rest",
                        new JointCrowd(10, 50, true, Assemblies::doors))
                .finding(DRIFT);
        list.fromGame(
                "J12",
                "a bridge stands under its load, and a cantilever at its wall",
                HangingChains::bridges);
        list.add(
                "J15/contraptions",
                "trees of any joints and shapes fall on each other without overlap",
                Contraptions::run);
        list.add(
                        "J12/taut",
                        "a bridge as long as its span stays closed under falling bodies",
                        TautBridges::fallOnAll)
                .finding(SAG);
        return list.all();
    }
}
