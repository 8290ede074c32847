package org.lwjgl.opengl;

import org.teavm.jso.JSBody;
import org.teavm.jso.typedarrays.Float32Array;
import org.teavm.jso.webgl.WebGL2RenderingContext;
import org.teavm.jso.webgl.WebGLBuffer;
import org.teavm.jso.webgl.WebGLFramebuffer;
import org.teavm.jso.webgl.WebGLProgram;
import org.teavm.jso.webgl.WebGLShader;
import org.teavm.jso.webgl.WebGLTexture;
import org.teavm.jso.webgl.WebGLUniformLocation;
import org.teavm.jso.webgl.WebGLVertexArrayObject;

import java.nio.FloatBuffer;

/** The functions of OpenGL 3.3 that the game calls, by the WebGL 2 of one canvas. */
public final class GL33C {

    /** First line of the game's shaders, and of WebGL's. */
    private static final String VERSION = "#version 330 core";

    private static final String VERSION_HERE =
            "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                    + "precision highp sampler2DArray;";

    private static final Names<WebGLShader> SHADERS = new Names<>();
    private static final Names<WebGLProgram> PROGRAMS = new Names<>();
    private static final Names<WebGLBuffer> BUFFERS = new Names<>();
    private static final Names<WebGLVertexArrayObject> ARRAYS = new Names<>();
    private static final Names<WebGLTexture> TEXTURES = new Names<>();
    private static final Names<WebGLFramebuffer> FRAMES = new Names<>();
    private static final Names<WebGLUniformLocation> PLACES = new Names<>();

    private static WebGL2RenderingContext gl;

    private GL33C() {}

    /** Sets the canvas of all calls. */
    public static void use(WebGL2RenderingContext context) {
        gl = context;
    }

    public static int glCreateShader(int stage) {
        return SHADERS.add(gl.createShader(stage));
    }

    public static void glShaderSource(int shader, CharSequence text) {
        gl.shaderSource(SHADERS.get(shader), text.toString().replace(VERSION, VERSION_HERE));
    }

    public static void glCompileShader(int shader) {
        gl.compileShader(SHADERS.get(shader));
    }

    public static int glGetShaderi(int shader, int what) {
        return gl.getShaderParameterb(SHADERS.get(shader), what) ? 1 : 0;
    }

    public static String glGetShaderInfoLog(int shader) {
        return gl.getShaderInfoLog(SHADERS.get(shader));
    }

    public static void glDeleteShader(int shader) {
        gl.deleteShader(SHADERS.remove(shader));
    }

    public static int glCreateProgram() {
        return PROGRAMS.add(gl.createProgram());
    }

    public static void glAttachShader(int program, int shader) {
        gl.attachShader(PROGRAMS.get(program), SHADERS.get(shader));
    }

    public static void glLinkProgram(int program) {
        gl.linkProgram(PROGRAMS.get(program));
    }

    public static int glGetProgrami(int program, int what) {
        return gl.getProgramParameterb(PROGRAMS.get(program), what) ? 1 : 0;
    }

    public static String glGetProgramInfoLog(int program) {
        return gl.getProgramInfoLog(PROGRAMS.get(program));
    }

    public static void glUseProgram(int program) {
        gl.useProgram(PROGRAMS.get(program));
    }

    public static void glDeleteProgram(int program) {
        gl.deleteProgram(PROGRAMS.remove(program));
    }

    public static int glGetUniformLocation(int program, CharSequence name) {
        return PLACES.add(gl.getUniformLocation(PROGRAMS.get(program), name.toString()));
    }

    public static void glUniform1i(int place, int value) {
        gl.uniform1i(PLACES.remove(place), value);
    }

    public static void glUniform1f(int place, float value) {
        gl.uniform1f(PLACES.remove(place), value);
    }

    public static void glUniform4f(int place, float x, float y, float z, float w) {
        gl.uniform4f(PLACES.remove(place), x, y, z, w);
    }

    public static int glGenBuffers() {
        return BUFFERS.add(gl.createBuffer());
    }

    public static void glBindBuffer(int kind, int buffer) {
        gl.bindBuffer(kind, BUFFERS.get(buffer));
    }

    /** Sends the floats between a buffer's position and its limit. */
    public static void glBufferData(int kind, FloatBuffer floats, int use) {
        send(gl, kind, Float32Array.fromJavaBuffer(floats.slice()), use);
    }

    public static void glDeleteBuffers(int buffer) {
        gl.deleteBuffer(BUFFERS.remove(buffer));
    }

    public static int glGenVertexArrays() {
        return ARRAYS.add(gl.createVertexArray());
    }

    public static void glBindVertexArray(int array) {
        gl.bindVertexArray(ARRAYS.get(array));
    }

    public static void glDeleteVertexArrays(int array) {
        gl.deleteVertexArray(ARRAYS.remove(array));
    }

    public static void glEnableVertexAttribArray(int index) {
        gl.enableVertexAttribArray(index);
    }

    public static void glVertexAttribPointer(
            int index, int size, int type, boolean isNormalized, int stride, long offset) {
        gl.vertexAttribPointer(index, size, type, isNormalized, stride, (int) offset);
    }

    public static void glVertexAttribDivisor(int index, int divisor) {
        setDivisor(gl, index, divisor);
    }

    public static int glGenTextures() {
        return TEXTURES.add(gl.createTexture());
    }

    public static void glBindTexture(int kind, int texture) {
        gl.bindTexture(kind, TEXTURES.get(texture));
    }

    public static void glTexParameteri(int kind, int what, int value) {
        gl.texParameteri(kind, what, value);
    }

    /** Makes an empty texture; {@code pixels} are never copied. */
    public static void glTexImage3D(
            int kind,
            int level,
            int format,
            int width,
            int height,
            int depth,
            int border,
            int order,
            int type,
            long pixels) {
        makeTexture(gl, kind, format, width, height, depth, order, type);
    }

    public static void glGenerateMipmap(int kind) {
        gl.generateMipmap(kind);
    }

    public static void glDeleteTextures(int texture) {
        gl.deleteTexture(TEXTURES.remove(texture));
    }

    public static int glGenFramebuffers() {
        return FRAMES.add(gl.createFramebuffer());
    }

    public static void glBindFramebuffer(int kind, int frame) {
        gl.bindFramebuffer(kind, FRAMES.get(frame));
    }

    public static void glFramebufferTextureLayer(
            int kind, int attachment, int texture, int level, int layer) {
        gl.framebufferTextureLayer(kind, attachment, TEXTURES.get(texture), level, layer);
    }

    public static void glBlitFramebuffer(
            int left,
            int bottom,
            int right,
            int top,
            int toLeft,
            int toBottom,
            int toRight,
            int toTop,
            int what,
            int filter) {
        gl.blitFramebuffer(
                left, bottom, right, top, toLeft, toBottom, toRight, toTop, what, filter);
    }

    public static void glDeleteFramebuffers(int frame) {
        gl.deleteFramebuffer(FRAMES.remove(frame));
    }

    public static void glEnable(int what) {
        gl.enable(what);
    }

    public static void glDisable(int what) {
        gl.disable(what);
    }

    public static void glBlendFunc(int source, int target) {
        gl.blendFunc(source, target);
    }

    public static void glViewport(int x, int y, int width, int height) {
        gl.viewport(x, y, width, height);
    }

    public static void glDrawArrays(int kind, int first, int count) {
        gl.drawArrays(kind, first, count);
    }

    public static void glDrawArraysInstanced(int kind, int first, int count, int instances) {
        gl.drawArraysInstanced(kind, first, count, instances);
    }

    @JSBody(
            params = {"gl", "index", "divisor"},
            script = "gl.vertexAttribDivisor(index, divisor);")
    private static native void setDivisor(WebGL2RenderingContext gl, int index, int divisor);

    @JSBody(
            params = {"gl", "kind", "format", "width", "height", "depth", "order", "type"},
            script =
                    "gl.texImage3D("
                            + "kind, 0, format, width, height, depth, 0, order, type, null);")
    private static native void makeTexture(
            WebGL2RenderingContext gl,
            int kind,
            int format,
            int width,
            int height,
            int depth,
            int order,
            int type);

    @JSBody(
            params = {"gl", "kind", "floats", "use"},
            script = "gl.bufferData(kind, floats, use);")
    private static native void send(
            WebGL2RenderingContext gl, int kind, Float32Array floats, int use);
}
