using Alate.Crowds;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Materials of a USD file as UsdPreviewSurface: a part shows its picture, which is a file of its own, or the colours of its vertices, or
/// one pale colour.
/// </summary>
internal sealed class UsdMaterials
{
    /// <summary>Name of the prim that holds them.</summary>
    public const string Scope = "looks";

    private const string k_Surface = "surface", k_Colour = "colour", k_Reader = "reader";

    private readonly InsectBake m_Bake;
    private readonly BakePictures m_Pictures;
    private readonly Dictionary<BakedPart, string> m_NameOf = [];

    private readonly List<Look> m_Looks = [];
    private readonly HashSet<string> m_Names = [];

    public UsdMaterials(InsectBake bake, BakePictures pictures)
    {
        m_Bake = bake;
        m_Pictures = pictures;
        foreach (BakedPart part in bake.Surface.Parts)
            m_NameOf.Add(part, NameOf(part));
    }

    /// <summary>Pictures and the names of their files, beside the USD file.</summary>
    public IEnumerable<(string File, byte[] Png)> Files =>
        m_Looks.Where(look => look.Picture != null).Select(look => (look.File, look.Picture.Png));

    /// <summary>Name of a part's material.</summary>
    public string Of(BakedPart part) => m_NameOf[part];

    /// <summary>Writes the colours of a part's vertices, where its material shows them.</summary>
    public void WriteColours(UsdaWriter text, BakedPart part, int[] vertices)
    {
        if (m_Pictures.Of(part) != null || !part.HasColours)
            return;
        Color32[] colours = Array.ConvertAll(vertices, vertex => m_Bake.Surface.Colours[vertex]);
        text.Set("color3f[] primvars:displayColor", UsdaWriter.List(colours, Light), "interpolation = \"vertex\"");
        if (BakePictures.IsGlass(m_Bake, part))
        {
            text.Set("float[] primvars:displayOpacity", UsdaWriter.List(colours, colour => UsdaWriter.Number(colour.a / 255f)),
                "interpolation = \"vertex\"");
        }
    }

    /// <summary>Writes the materials.</summary>
    /// <param name="text">The file.</param>
    /// <param name="parent">Path of the prim that is open.</param>
    public void Write(UsdaWriter text, string parent)
    {
        text.Begin("Scope", Scope);
        foreach (Look look in m_Looks)
        {
            string path = $"{parent}/{Scope}/{look.Name}";
            text.Begin("Material", look.Name);
            text.Set("token outputs:surface.connect", $"<{path}/{k_Surface}.outputs:surface>");
            WriteSurface(text, path, look);
            if (look.Picture != null)
            {
                WritePicture(text, path, look);
                WriteReader(text, k_Reader, "float2", "st");
            }
            else if (look.HasColours)
            {
                WriteReader(text, k_Colour, "float3", "displayColor");
                if (look.IsGlass)
                    WriteReader(text, k_Reader, "float", "displayOpacity");
            }

            text.End();
        }

        text.End();
    }

    private static void WriteSurface(UsdaWriter text, string path, Look look)
    {
        bool isPicture = look.Picture != null;
        text.Begin("Shader", k_Surface);
        text.Set("uniform token info:id", UsdaWriter.Text("UsdPreviewSurface"));
        if (isPicture || look.HasColours)
            text.Set("color3f inputs:diffuseColor.connect", $"<{path}/{k_Colour}.outputs:{(isPicture ? "rgb" : "result")}>");
        else
            text.Set("color3f inputs:diffuseColor", Tuple(FileColours.Membrane));
        text.Set("float inputs:metallic", "0");
        if (look.IsGlass || look.IsCut)
        {
            text.Set("float inputs:opacity.connect", isPicture ? $"<{path}/{k_Colour}.outputs:a>" : $"<{path}/{k_Reader}.outputs:result>");
        }
        if (look.IsCut)
            text.Set("float inputs:opacityThreshold", "0.5");
        text.Set("float inputs:roughness", UsdaWriter.Number(FileColours.Roughness));
        text.Declare("token outputs:surface");
        text.End();
    }

    private static void WritePicture(UsdaWriter text, string path, Look look)
    {
        text.Begin("Shader", k_Colour);
        text.Set("uniform token info:id", UsdaWriter.Text("UsdUVTexture"));
        text.Set("asset inputs:file", $"@./{look.File}@");
        text.Set("token inputs:sourceColorSpace", UsdaWriter.Text("sRGB"));
        text.Set("float2 inputs:st.connect", $"<{path}/{k_Reader}.outputs:result>");
        text.Set("token inputs:wrapS", UsdaWriter.Text("clamp"));
        text.Set("token inputs:wrapT", UsdaWriter.Text("clamp"));
        if (look.IsGlass || look.IsCut)
            text.Declare("float outputs:a");
        text.Declare("float3 outputs:rgb");
        text.End();
    }

    private static void WriteReader(UsdaWriter text, string name, string type, string read)
    {
        text.Begin("Shader", name);
        text.Set("uniform token info:id", UsdaWriter.Text("UsdPrimvarReader_" + type));
        text.Set("string inputs:varname", UsdaWriter.Text(read));
        text.Declare($"{type} outputs:result");
        text.End();
    }

    private string NameOf(BakedPart part)
    {
        WingTexture picture = m_Pictures.Of(part);
        var look = new Look(null, picture, picture == null && part.HasColours, picture?.IsGlass ?? BakePictures.IsGlass(m_Bake, part));
        string name = m_Looks.FirstOrDefault(known => known with { Name = null } == look).Name;
        if (name == null)
            m_Looks.Add(look with { Name = name = UsdaWriter.Unused(part.Name, m_Names) });
        return name;
    }

    private static string Light(Color32 colour) =>
        Tuple((FileColours.Linear(colour.r), FileColours.Linear(colour.g), FileColours.Linear(colour.b)));

    private static string Tuple((double Red, double Green, double Blue) light) =>
        UsdaWriter.Tuple(new float3((float)light.Red, (float)light.Green, (float)light.Blue));

    /// <summary>A material: its picture, or whether its parts have colours; and whether some of it is seen through.</summary>
    private readonly record struct Look(string Name, WingTexture Picture, bool HasColours, bool IsGlass)
    {
        /// <summary>File of the picture.</summary>
        public string File => Name + ".png";

        /// <summary>True where the opacity of the picture is the wing's outline.</summary>
        public bool IsCut => Picture?.Opacity == PictureOpacity.Cut;
    }
}
