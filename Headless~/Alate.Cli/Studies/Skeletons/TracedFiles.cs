namespace Alate.Cli;

/// <summary>Names of the files of a wing that was found in a picture or a mesh, in one folder.</summary>
/// <param name="Name">Of the wing; its material has it too.</param>
internal sealed record TracedFiles(string Name)
{
    public string Skeleton { get; init; } = Name + ".json";

    public string Overlay { get; init; } = Name + ".svg";

    public string Mesh => Name + ".obj";

    public string Library => Name + ".mtl";

    public string Picture => Name + ".png";

    public string[] All => [Skeleton, Mesh, Library, Picture, Overlay];
}
