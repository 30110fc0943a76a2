using System.CommandLine;
using Alate.Authoring;
using UnityEngine;

namespace Alate.Cli;

/// <summary><c>skeleton from-image IMAGE</c>: makes a mesh and a skeleton from a picture of a wing.</summary>
internal static class SkeletonFromImageCommand
{
    private static readonly TracedFiles s_Files = new("wing") { Skeleton = "skeleton.json", Overlay = "overlay.svg" };

    public static Command Create(TextWriter output)
    {
        WingTracingSettings standard = WingTracingSettings.Default;
        var image = new Argument<string>("IMAGE")
        {
            Description = "A PNG or JPEG of one wing on plain or transparent ground: silhouette, line drawing or photo.",
        };
        Option<int?> chains = Numbers.OptionalCount(
            "--chains", "N", WingSkeleton.MinChains, WingSkeleton.MaxChains,
            $"Chains of joints, {WingSkeleton.MinChains} to {WingSkeleton.MaxChains}. [default: 5]");
        Option<int?> joints = Numbers.OptionalCount(
            "--joints", "N", WingSkeleton.MinJoints, WingSkeleton.MaxJoints,
            $"Joints of each chain, {WingSkeleton.MinJoints} to {WingSkeleton.MaxJoints}. [default: 5]");
        Option<int?> triangles = Numbers.OptionalCount(
            "--triangles", "N", WingTracingSettings.MinTriangles, WingTracingSettings.MaxTriangles,
            $"Triangles of the mesh, {WingTracingSettings.MinTriangles} to "
            + $"{WingTracingSettings.MaxTriangles}; it gets exactly so many. [default: 1000]");
        Option<double[]> hinge = Numbers.Pair(
            "--hinge", "X,Y", 0, WingPicture.MaxSide,
            "Where the wing turns, pixels from the picture's top left corner. [default: where veins meet, else guessed]");
        Option<Vector2?> leading = Choice.Optional(
            "--leading", "The leading edge's side of the picture. [default: up]", WingSource.Sides);
        Option<double> length = Numbers.Option(
            "--length", "METRES", standard.length, 1e-6, 1e6,
            "Length of the wing from hinge to tip in the mesh, metres, 0.000001 to 1000000.");
        var widths =
            new Option<bool>("--vein-widths") { Description = "Measures the veins that chains follow, and makes thick ones stiffer." };
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/IMAGE]" };
        var command = new Command(
            "from-image", "Makes a mesh and a skeleton from a picture of a wing; chains follow its veins where it shows any.")
        {
            image, chains, joints, triangles, hinge, leading, length, widths, folder,
        };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            var settings = new WingTracingSettings
            {
                chains = parsed.GetValue(chains) ?? standard.chains,
                jointsPerChain = parsed.GetValue(joints) ?? standard.jointsPerChain,
                triangles = parsed.GetValue(triangles) ?? standard.triangles,
                hinge = parsed.GetValue(hinge) is { Length: 2 } at ? new Vector2((float)at[0], (float)at[1]) : null,
                forward = parsed.GetValue(leading),
                length = (float)parsed.GetValue(length),
                veinWidths = parsed.GetValue(widths),
            };
            string file = parsed.GetValue(image);
            Run(file, settings, parsed.GetValue(folder) ?? Path.Combine("out", Path.GetFileNameWithoutExtension(file)), output);
            return 0;
        });
        return command;
    }

    private static void Run(string file, in WingTracingSettings settings, string path, TextWriter output)
    {
        var wing = TracedWing.Of(file, settings);
        using var folder = OutputFolder.Prepare(path, s_Files.All);
        wing.Write(folder, s_Files);
        folder.Commit();
        output.WriteLine(wing.Summary);
        output.WriteLine($"Wrote {s_Files.Skeleton}, {s_Files.Mesh} with {s_Files.Library} and {s_Files.Picture}, "
            + $"and {s_Files.Overlay} into {path}.");
    }

    private const string k_Examples =
        "Examples:\n"
        + "  skeleton from-image wing.png\n"
        + "  skeleton from-image wing.png --chains 6 --joints 5 --triangles 2000 --hinge 42,310 --length 0.061 --out mine\n\n"
        + "Writes into the output folder:\n"
        + "  skeleton.json  the skeleton, for 'fly --mesh wing.obj --skeleton skeleton.json --species NAME'\n"
        + "  wing.obj       the wing's mesh with the picture's texture coordinates; hinge at the origin, leading edge towards +Z\n"
        + "  wing.mtl, wing.png  its material: the picture, which 'fly --mesh' puts on the wing\n"
        + "  overlay.svg    the picture with what was found in it: outline, mesh, veins, chains\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
