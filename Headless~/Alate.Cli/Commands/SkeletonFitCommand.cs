using System.CommandLine;
using Alate.Authoring;
using Alate.Fitting;
using UnityEngine;

namespace Alate.Cli;

/// <summary><c>skeleton fit MESH.obj</c>: lays a skeleton into a wing's mesh.</summary>
internal static class SkeletonFitCommand
{
    private const double k_Far = 1e9;

    public static Command Create(TextWriter output)
    {
        var mesh = new Argument<string>("MESH.obj") { Description = "A wing at rest." };
        Option<int?> chains = Numbers.OptionalCount(
            "--chains", "N", WingSkeleton.MinChains, WingSkeleton.MaxChains,
            $"Chains of joints, {WingSkeleton.MinChains} to {WingSkeleton.MaxChains}. [default: 5]");
        Option<int?> joints = Numbers.OptionalCount(
            "--joints", "N", WingSkeleton.MinJoints, WingSkeleton.MaxJoints,
            $"Joints of each chain, {WingSkeleton.MinJoints} to {WingSkeleton.MaxJoints}. [default: 5]");
        Option<double[]> hinge = Numbers.Vector(
            "--hinge", "X,Y,Z", k_Far, "Where the wing turns, in the mesh's space. [default: guessed]");
        Option<double[]> body = Numbers.Vector(
            "--body", "X,Y,Z", k_Far, "A point of the body, where the hinge is not known. [default: guessed]");
        Option<double[]> forward = Numbers.Vector(
            "--forward", "X,Y,Z", k_Far, "The way the insect faces: the side of the leading edge. [default: 0,0,1]");
        Option<double[]> up = Numbers.Vector("--up", "X,Y,Z", k_Far, "The wing's upper side. [default: 0,1,0]");
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/MESH]" };
        var command = new Command("fit", "Lays a skeleton into a wing's mesh: chains that fan from its base to its margin.")
        {
            mesh, chains, joints, hinge, body, forward, up, folder,
        };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            SkeletonFitSettings settings = SkeletonFitSettings.Default;
            settings.chains = parsed.GetValue(chains) ?? settings.chains;
            settings.jointsPerChain = parsed.GetValue(joints) ?? settings.jointsPerChain;
            settings.forward = Vector(parsed.GetValue(forward)) ?? settings.forward;
            settings.up = Vector(parsed.GetValue(up));
            string file = parsed.GetValue(mesh);
            ObjMesh wing = TextFile.Read(file, ObjReader.Read, InputFile.Mesh);
            settings.hinge = wing.Placed(parsed.GetValue(hinge));
            settings.bodyPoint = wing.Placed(parsed.GetValue(body));
            settings.isOriginUnknown = wing.Origin != default;
            Run(file, wing, settings, parsed.GetValue(folder) ?? Path.Combine("out", Path.GetFileNameWithoutExtension(file)), output);
            return 0;
        });
        return command;
    }

    private static void Run(string file, ObjMesh mesh, in SkeletonFitSettings settings, string path, TextWriter output)
    {
        const string k_Skeleton = "skeleton.json", k_Picture = "skeleton.svg";
        SkeletonFit fit = FittedWing.Fit(mesh.ToSurface(file), settings);
        using var folder = OutputFolder.Prepare(path, k_Skeleton, k_Picture);
        folder.Write(k_Skeleton, stream => stream.Write(Encoding.UTF8.GetBytes(SkeletonJson.Write(fit.Skeleton, mesh.Origin))));
        folder.Write(k_Picture, stream => stream.Write(Encoding.UTF8.GetBytes(SkeletonPicture.Draw(fit))));
        folder.Commit();
        output.WriteLine(FittedWing.Describe(fit));
        output.WriteLine($"Wrote {k_Skeleton} and {k_Picture} into {path}.");
    }

    private static Vector3? Vector(double[] given) =>
        given is { Length: 3 } ? new Vector3((float)given[0], (float)given[1], (float)given[2]) : null;

    private const string k_Examples =
        "Examples:\n"
        + "  skeleton fit wing.obj\n"
        + "  skeleton fit wing.obj --chains 7 --joints 6 --hinge 0,0,0.1 --forward 0,0,1 --out mine\n\n"
        + "Writes into the output folder:\n"
        + "  skeleton.json  the skeleton, in the mesh's space, for 'fly --mesh wing.obj --skeleton skeleton.json --species NAME'\n"
        + "  skeleton.svg   the wing's outline and the chains, seen from above\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
