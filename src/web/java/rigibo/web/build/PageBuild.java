package rigibo.web.build;

import org.teavm.tooling.TeaVMTargetType;
import org.teavm.tooling.TeaVMTool;
import org.teavm.tooling.TeaVMToolException;
import org.teavm.vm.TeaVMOptimizationLevel;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/**
 * Writes the page as a folder of static files. Programs become WebAssembly: TeaVM's JavaScript
 * omits the parentheses of a + (b + c), which changes the last bit of sums (decision 0128).
 */
final class PageBuild {

    /** The checkout that the page is made from. */
    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    private final Path folder;

    PageBuild(Path folder) {
        this.folder = folder;
    }

    /** Builds the page of the game. */
    void build() throws IOException, TeaVMToolException {
        Files.createDirectories(folder);
        StrictRuntime.write(folder.resolve("runtime.js"));
        new GameFiles(HOME).write(folder);
        copy("/web/index.html", "index.html");
        copy("/web/game.js", "game.js");
        copy("/web/aside.js", "aside.js");
        copy("/web/game.css", "game.css");
        copy("/web/manifest.webmanifest", "manifest.webmanifest");
        copy("/web/icon.svg", "icon.svg");
        compile("rigibo.web.game.GamePage", "game");
        Offline.write(folder);
    }

    /** Builds the page that compares the bits of recorded runs and programs with the JVM's. */
    void buildBits(Path runs) throws IOException, TeaVMToolException {
        buildLines();
        GameFiles.writeRuns(HOME, runs, folder.resolve("bits.txt"));
        compile("rigibo.web.Bits", "bits");
    }

    /** Builds the page that compares the bits of the hard cases with the JVM's. */
    void buildCases() throws IOException, TeaVMToolException {
        buildLines();
        compile("rigibo.web.CaseBits", "cases");
    }

    /** Builds the page that times scenes, as WebAssembly and as JavaScript. */
    void buildTimes() throws IOException, TeaVMToolException {
        buildLines();
        compile("rigibo.web.Times", "times");
        TeaVMTool script = tool("rigibo.web.Times", "times-script.js");
        script.setTargetType(TeaVMTargetType.JAVASCRIPT);
        generate(script);
    }

    private void buildLines() throws IOException {
        Files.createDirectories(folder);
        StrictRuntime.write(folder.resolve("runtime.js"));
        copy("/web/lines.html", "lines.html");
        copy("/web/lines.js", "lines.js");
    }

    private void copy(String resource, String file) throws IOException {
        try (InputStream from = PageBuild.class.getResourceAsStream(resource)) {
            Files.copy(from, folder.resolve(file), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Compiles a program, and writes the functions by which it calls the page beside it. */
    private void compile(String start, String name) throws TeaVMToolException {
        TeaVMTool tool = tool(start, name + ".wasm");
        tool.setTargetType(TeaVMTargetType.WEBASSEMBLY_GC);
        tool.getProperties()
                .setProperty(FunctionTable.FILE, folder.resolve(name + "-functions.js").toString());
        generate(tool);
    }

    private TeaVMTool tool(String start, String file) {
        TeaVMTool tool = new TeaVMTool();
        tool.setMainClass(start);
        tool.setTargetDirectory(folder.toFile());
        tool.setTargetFileName(file);
        tool.setOptimizationLevel(TeaVMOptimizationLevel.ADVANCED);
        tool.setObfuscated(true);
        // Without checks that turn wrong indices and nulls into exceptions: WebAssembly stops there
        // by itself, and steps take two thirds of the time (decision 0185).
        tool.setStrict(false);
        tool.setAssertionsRemoved(true);
        tool.getTransformers().add(SignedZeros.class.getName());
        tool.getTransformers().add(MissingMethods.class.getName());
        tool.setClassLoader(PageClasses.find());
        tool.setClassPath(PageClasses.places());
        return tool;
    }

    private static void generate(TeaVMTool tool) throws TeaVMToolException {
        tool.generate();
        String problems = Problems.of(tool.getProblemProvider());
        if (!problems.isEmpty()) {
            throw new TeaVMToolException("it cannot run in a browser:\n" + problems);
        }
    }
}
