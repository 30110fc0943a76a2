using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>
/// A baked insect as OpenVAT's textures: offsets from the mesh at rest in Blender's axes, metres, each channel between the least and the
/// largest of all. Every clip ends with its first frame again, so that readers which go from the first row of a range to its last come
/// round without a jump.
/// </summary>
internal sealed class OpenVat
{
    private readonly InsectBake m_Bake;
    private readonly List<(BakedClip Clip, int First)> m_Ranges = [];
    private readonly float3 m_Min, m_Max;

    /// <exception cref="BakeException">The texture would be too large.</exception>
    public OpenVat(InsectBake bake, int maxSize, bool packsNormals)
    {
        m_Bake = bake;
        int frames = 0;
        foreach (BakedClip clip in bake.Clips)
        {
            m_Ranges.Add((clip, frames));
            frames += clip.Frames.Count + 1;
        }

        Layout = BakeLayout.Fit(bake.Surface.VertexCount, frames, maxSize, packsNormals);
        (m_Min, m_Max) = Range();
        Positions = new PngPicture(Layout.Width, Layout.Height);
        Normals = packsNormals ? Positions : new PngPicture(Layout.Width, Layout.Height);
        foreach ((BakedClip clip, int first) in m_Ranges)
        {
            for (int frame = 0; frame <= clip.Frames.Count; frame++)
                Paint(clip.Frames[frame % clip.Frames.Count], first + frame);
        }
    }

    public BakeLayout Layout { get; }

    public PngPicture Positions { get; }

    /// <summary>The same as <see cref="Positions"/> where the lower half holds the normals.</summary>
    public PngPicture Normals { get; }

    /// <summary>Writes the mesh at rest, with the pictures on it.</summary>
    public void WriteMesh(BakePictures pictures, Stream stream) => ProxyGlb.Write(m_Bake, pictures, Layout, stream);

    public void WriteJson(Stream stream)
    {
        var animations = new JsonObject();
        foreach ((BakedClip clip, int first) in m_Ranges)
        {
            animations[clip.Name] = new JsonObject
            {
                ["startFrame"] = first,
                ["endFrame"] = first + clip.Frames.Count,
                ["framerate"] = clip.Frequency * clip.Frames.Count,
                ["looping"] = true,
            };
        }

        var root = new JsonObject
        {
            ["os-remap"] = new JsonObject { ["Min"] = Vector(m_Min), ["Max"] = Vector(m_Max), ["Frames"] = Layout.FrameCount },
            ["animations"] = animations,
            ["axes"] = "Blender: X to the left of the insect, Y back, Z up, right-handed; metres",
        };
        var options = new JsonWriterOptions { Indented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
        using var writer = new Utf8JsonWriter(stream, options);
        root.WriteTo(writer);
    }

    private void Paint(BakedFrame frame, int row)
    {
        int normalRows = Layout.HoldsNormals ? Layout.NormalRows : 0;
        for (int vertex = 0; vertex < frame.Positions.Length; vertex++)
        {
            int2 pixel = Layout.PixelOf(vertex, row);
            Positions.Set(pixel.x, pixel.y, (Offset(frame, vertex) - m_Min) / math.max(m_Max - m_Min, 1e-12f));
            Normals.Set(pixel.x, pixel.y + normalRows, 0.5f + 0.5f * FileAxes.ToBlender(frame.Normals[vertex]));
        }
    }

    private (float3 Min, float3 Max) Range()
    {
        float3 min = 0f, max = 0f;
        foreach (BakedClip clip in m_Bake.Clips)
        {
            foreach (BakedFrame frame in clip.Frames)
            {
                for (int vertex = 0; vertex < frame.Positions.Length; vertex++)
                {
                    float3 offset = Offset(frame, vertex);
                    min = math.min(min, offset);
                    max = math.max(max, offset);
                }
            }
        }

        return (min, max);
    }

    private float3 Offset(BakedFrame frame, int vertex) =>
        FileAxes.ToBlender(frame.Positions[vertex] - (float3)m_Bake.Surface.Positions[vertex]) * m_Bake.MetresPerUnit;

    private static JsonArray Vector(float3 value) => new(value.x, value.y, value.z);
}
