using System.Text.Json.Nodes;

namespace Alate.Formats;

/// <summary>Materials of a glTF file and the pictures on them, each once.</summary>
internal sealed class GlbLooks(GlbBuffer buffer)
{
    private const string k_Transmission = "KHR_materials_diffuse_transmission";
    private const string k_Unlit = "KHR_materials_unlit";
    private const int k_Linear = 9729, k_LinearMipmap = 9987, k_Clamped = 33071;

    /// <summary>
    /// Share of the light that passes a wing, scattered: between those of a white butterfly's scales and of bare membrane.
    /// </summary>
    private const double k_Passing = 0.35;

    private readonly JsonArray m_Materials = [], m_Textures = [], m_Images = [];
    private readonly Dictionary<(bool IsPainted, bool IsGlass), int> m_Plain = [];
    private readonly Dictionary<byte[], int> m_Painted = [];

    /// <summary>A material that shows vertex colours, or one pale colour.</summary>
    public int Plain(bool isPainted, bool isGlass)
    {
        if (!m_Plain.TryGetValue((isPainted, isGlass), out int material))
        {
            m_Plain.Add((isPainted, isGlass), material = Plain(isPainted, isGlass, isGlass ? "glass" : isPainted ? "painted" : "membrane"));
        }
        return material;
    }

    /// <summary>A material of its own that shows vertex colours, or one pale colour.</summary>
    public int Plain(bool isPainted, bool isGlass, string name) => Add(GltfMaterial.Of(isPainted, PictureOpacities.Of(isGlass), name));

    /// <summary>A material that shows a picture, and lets light pass in viewers that know how.</summary>
    /// <param name="png">The picture's file; a material for each array.</param>
    /// <param name="opacity">What its opacity is for.</param>
    /// <param name="name">What it shows.</param>
    public int Of(byte[] png, PictureOpacity opacity, string name)
    {
        if (m_Painted.TryGetValue(png, out int material))
            return material;
        m_Images.Add(new JsonObject { ["name"] = name, ["bufferView"] = buffer.AddFile(png), ["mimeType"] = "image/png" });
        m_Textures.Add(new JsonObject { ["sampler"] = 0, ["source"] = m_Images.Count - 1 });
        JsonObject look = GltfMaterial.Of(isPainted: true, opacity, name);
        look["pbrMetallicRoughness"]["baseColorTexture"] = new JsonObject { ["index"] = m_Textures.Count - 1 };
        if (opacity != PictureOpacity.Clear)
            look["extensions"] = new JsonObject { [k_Transmission] = new JsonObject { ["diffuseTransmissionFactor"] = k_Passing } };
        m_Painted.Add(png, material = Add(look));
        return material;
    }

    /// <summary>A material that shows vertex colours as they are, in any light.</summary>
    public int Unlit(string name)
    {
        JsonObject look = GltfMaterial.Of(isPainted: true, PictureOpacity.Clear, name);
        look["extensions"] = new JsonObject { [k_Unlit] = new JsonObject() };
        return Add(look);
    }

    /// <summary>Adds what there is to the file.</summary>
    public void WriteTo(JsonObject gltf)
    {
        gltf["materials"] = m_Materials;
        string[] used = [.. new[] { k_Transmission, k_Unlit }.Where(m_Materials.ToJsonString().Contains)];
        if (used.Length > 0)
            gltf["extensionsUsed"] = new JsonArray([.. used]);
        if (m_Images.Count == 0)
            return;
        gltf["samplers"] = new JsonArray(
            new JsonObject { ["magFilter"] = k_Linear, ["minFilter"] = k_LinearMipmap, ["wrapS"] = k_Clamped, ["wrapT"] = k_Clamped });
        gltf["textures"] = m_Textures;
        gltf["images"] = m_Images;
    }

    private int Add(JsonObject material)
    {
        m_Materials.Add(material);
        return m_Materials.Count - 1;
    }
}
