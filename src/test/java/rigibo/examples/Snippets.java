package rigibo.examples;

import rigibo.examples.JdkTool.Said;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Pieces of Java from Javadoc and pages, each compiled as the body of a method. */
public final class Snippets {

    /** Variables that a snippet may use without declaring them. */
    private static final String GIVEN =
            """
            import java.util.*;
            import rigibo.backend.*;
            import rigibo.backend.effect.*;
            import rigibo.backend.geometry.*;
            import rigibo.backend.setup.*;

            class Example%d {
                Pool pool;
                RigidBody crate;
                RigidBody door;
                Material wood;
                Material ice;

                void shown() throws Exception {
            %s
                }
            }
            """;

    private Snippets() {}

    /** Compiles all of them into a folder. */
    public static Said compile(Path folder, List<String> pieces) throws IOException {
        List<String> command =
                new ArrayList<>(List.of("-proc:none", "-Xlint:none", "-d", "" + folder));
        command.add("-cp");
        command.add(System.getProperty("java.class.path"));
        for (int i = 0; i < pieces.size(); i++) {
            Path source = folder.resolve("Example" + i + ".java");
            Files.writeString(source, String.format(GIVEN, i, pieces.get(i)));
            command.add("" + source);
        }
        return JdkTool.call("javac", command.toArray(String[]::new));
    }
}
