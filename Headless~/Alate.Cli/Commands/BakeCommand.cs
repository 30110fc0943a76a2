using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>bake SPECIES</c>: writes loops of an insect in formats that other programs read.</summary>
internal static class BakeCommand
{
    public static Command Create(TextWriter output)
    {
        var options = new BakeOptions();
        var command = new Command(
            "bake", "Bakes loops of an insect for other programs: OpenVAT textures, glTF with joints or shapes, or USD.");
        options.AddTo(command);
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            BakeReport.Run(options.Plan(parsed), output);
            return 0;
        });
        return command;
    }

    private const string k_Examples =
        "Examples:\n"
        + "  bake monarch --clips cruise,hover,rest\n"
        + "  bake firefly --format gltf-skin --out blender\n"
        + "  bake swallowtail --clips cruise --format gltf-morph --frames 24\n"
        + "  bake monarch --format gltf-skin --fps 24 --beats-per-second 2\n"
        + "  bake dragonfly --format usd --clips cruise,hover\n"
        + "  bake monarch --variant flight --clips hover,climb,turn-left\n"
        + "  bake monarch --variant flight --format gltf-skin --clips cruise,land,take-off --fps 24 --beats-per-second 2\n"
        + "  bake --mesh wing.obj --skeleton wing.json --species firefly\n\n"
        + "Writes into the output folder:\n"
        + "  openvat     SPECIES_vat/ with SPECIES.png, SPECIES-vnrm.png, SPECIES-remap_info.json and SPECIES.glb\n"
        + "  gltf-skin   SPECIES-skin.glb, joints that turn and move the wings\n"
        + "  gltf-morph  SPECIES-morph.glb, a shape for each frame\n"
        + "  usd         SPECIES_usd/ with SPECIES.usda, joints as in gltf-skin, and its pictures\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
