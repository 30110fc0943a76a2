using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace Alate.Formats;

/// <summary>Writes the binary form of glTF 2.0: a header, the JSON chunk, the binary chunk.</summary>
internal static class GlbWriter
{
    private const uint k_Magic = 0x46546C67, k_Json = 0x4E4F534A, k_Binary = 0x004E4942;
    private const int k_HeaderLength = 12, k_ChunkHeaderLength = 8;

    public static void Write(JsonObject gltf, byte[] binary, Stream stream)
    {
        var options = new JsonSerializerOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
        byte[] json = JsonSerializer.SerializeToUtf8Bytes(gltf, options);
        using var writer = new BinaryWriter(stream, System.Text.Encoding.UTF8, leaveOpen: true);
        writer.Write(k_Magic);
        writer.Write(2u);
        writer.Write((uint)(k_HeaderLength + 2 * k_ChunkHeaderLength + Padded(json.Length) + Padded(binary.Length)));
        WriteChunk(writer, k_Json, json, (byte)' ');
        WriteChunk(writer, k_Binary, binary, 0);
    }

    private static void WriteChunk(BinaryWriter writer, uint type, byte[] content, byte padding)
    {
        writer.Write((uint)Padded(content.Length));
        writer.Write(type);
        writer.Write(content);
        for (int k = content.Length; k < Padded(content.Length); k++)
            writer.Write(padding);
    }

    private static int Padded(int length) => (length + 3) & ~3;
}
