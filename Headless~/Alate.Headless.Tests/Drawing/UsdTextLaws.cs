using System.IO;
using System.Text;
using Alate.Formats;
using NUnit.Framework;

namespace Alate.Tests.Drawing;

/// <summary>
/// Text of a scene of Universal Scene Description, letter by letter, as its grammar wants lines where others want none; and its colours.
/// </summary>
public sealed class UsdTextLaws
{
    [Test]
    public void EveryValue_IsThatOfItsLight()
    {
        for (int value = 0; value < 256; value++)
            Assert.That(FileColours.Encoded(FileColours.Linear((byte)value)), Is.EqualTo(value));
        Assert.That((FileColours.Encoded(-1.0), FileColours.Encoded(7.0)), Is.EqualTo(((byte)0, (byte)255)));
    }

    [Test]
    public void Prims_StandWithinOneAnother_WithAttributesMetadataAndSamples()
    {
        using var stream = new MemoryStream();
        using (var writer = new UsdaWriter(stream, "moth", 24.0, 48.5))
        {
            writer.Begin("Xform", "moth");
            writer.Set("token kind", UsdaWriter.Text("a \"b\" \\"));
            writer.Begin("Mesh", "wing", "MaterialBindingAPI", "SkelBindingAPI");
            writer.Set("float3[] x", "[(1, 2, 3)]", "interpolation = \"vertex\"", "elementSize = 4");
            writer.Declare("token outputs:surface");
            writer.Samples("float y", [(0.0, "1"), (0.5, "2")]);
            writer.End();
            writer.End();
        }

        Assert.That(Encoding.UTF8.GetString(stream.ToArray()), Is.EqualTo("""
            #usda 1.0
            (
                defaultPrim = "moth"
                endTimeCode = 48.5
                framesPerSecond = 24
                metersPerUnit = 1
                startTimeCode = 0
                timeCodesPerSecond = 24
                upAxis = "Y"
            )

            def Xform "moth"
            {
                token kind = "a \"b\" \\"

                def Mesh "wing" (
                    prepend apiSchemas = ["MaterialBindingAPI", "SkelBindingAPI"]
                )
                {
                    float3[] x = [(1, 2, 3)] (
                        interpolation = "vertex"
                        elementSize = 4
                    )
                    token outputs:surface
                    float y.timeSamples = {
                        0: 1,
                        0.5: 2,
                    }
                }
            }

            """));
    }
}
