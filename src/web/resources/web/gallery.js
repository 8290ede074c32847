TeaVM.wasmGC.load('gallery.wasm')
    .then(program => program.exports.main([]))
    .catch(problem => {
        document.getElementById('problem').hidden = false;
        console.warn(problem);
    });
