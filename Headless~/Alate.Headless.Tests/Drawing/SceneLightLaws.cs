using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Drawing;

/// <summary>Light of a scene in closed forms: sky and ground, sun, what passes through, gleam, and lamps.</summary>
public sealed class SceneLightLaws
{
    private static readonly float3 s_Up = new(0f, 1f, 0f), s_Sun = new(0.8f, 0.7f, 0.5f), s_Colour = new(0.5f, 0.2f, 0.1f);
    private static readonly float3 s_Sky = new(0.3f, 0.4f, 0.6f), s_Equator = new(0.2f, 0.2f, 0.1f), s_Ground = new(0.05f, 0.04f, 0.02f);

    private static readonly SceneLight s_Around = new(s_Sky, s_Equator, s_Ground, s_Up, float3.zero, false, []),
        s_SunAlone = new(float3.zero, float3.zero, float3.zero, s_Up, s_Sun, false, []);

    [TestCase(1f, 0f)]
    [TestCase(0.5f, 0f)]
    [TestCase(0f, 0f)]
    [TestCase(-0.5f, 0f)]
    [TestCase(-1f, 0f)]
    [TestCase(0.5f, 0.4f)]
    [TestCase(-1f, 1f)]
    public void LightFromAllAround_IsThatOfTheSideWhichIsLit_AndOfTheOtherAsFarAsItPasses(float up, float through)
    {
        var normal = new float3(math.sqrt(1f - up * up), up, 0f);
        float3 expected = s_Colour * math.lerp(Around(up), Around(-up), 0.5f * through);

        AssertNear(s_Around.Of(Look(through, 0f, 1f), s_Colour, default, normal, normal, 1f), expected);

        static float3 Around(float up) => math.lerp(s_Equator, up > 0f ? s_Sky : s_Ground, math.abs(up));
    }

    // Lambert's law on the side that is seen; filtered once more by 0.35 and 0.65 of the colour from the other one.
    [TestCase(0f)]
    [TestCase(40f)]
    [TestCase(89f)]
    [TestCase(130f)]
    [TestCase(180f)]
    public void TheSun_FallsByTheCosine_OnEitherSide_AndByTheShareOfItThatIsNotInShadow(float degrees)
    {
        math.sincos(math.radians(degrees), out float sin, out float cos);
        float3 normal = new(sin, cos, 0f), dark = s_SunAlone.Of(Look(0.6f, 0f, 1f), s_Colour, default, normal, normal, 0f);
        float3 passes = cos > 0f ? s_Colour * cos : s_Colour * (0.35f + 0.65f * s_Colour) * (-0.6f * cos);

        AssertNear(dark, float3.zero);
        AssertNear(s_SunAlone.Of(Look(0.6f, 0f, 1f), s_Colour, default, normal, normal, 0.25f), 0.25f * s_Sun * passes);
        float3 turned = s_SunAlone.Of(Look(0.6f, 0f, 1f) with { IsTwoSided = true }, s_Colour, default, -normal, normal, 1f);
        AssertNear(turned, s_Sun * passes);
    }

    // Blinn: the cosine between the normal and the direction halfway to the eye, to the power of the shine.
    [TestCase(0f, 1f)]
    [TestCase(0f, 40f)]
    [TestCase(30f, 8f)]
    [TestCase(60f, 20f)]
    public void AGleam_FallsByThePowerOfTheHalfAngle(float degrees, float shine)
    {
        math.sincos(math.radians(degrees), out float sin, out float cos);
        float3 gleam = s_SunAlone.Of(Look(0f, 0.3f, shine), float3.zero, default, s_Up, new float3(sin, cos, 0f), 1f);

        AssertNear(gleam, s_Sun * 0.3f * math.pow(math.cos(math.radians(0.5f * degrees)), shine));
    }

    [TestCase(0.5f)]
    [TestCase(1f)]
    [TestCase(1.9f)]
    [TestCase(2.1f)]
    public void ALamp_FallsByTheSquareOfItsDistance_AndEndsAtItsRange(float away)
    {
        var lamp = new SceneLamp(new float3(1f, away + 1f, 0f), new float3(0.4f, 0.5f, 0.6f), 2f);
        SceneLight light = s_SunAlone with { Sun = float3.zero, Lamps = [lamp] };
        float3 seen = light.Of(Look(0f, 0f, 1f), s_Colour, new float3(1f, 1f, 0f), s_Up, s_Up, 1f);

        float end = math.saturate(1f - math.pow(away / 2f, 4f));
        AssertNear(seen, s_Colour * new float3(0.4f, 0.5f, 0.6f) * end * end / (away * away));
    }

    private static SceneLook Look(float through, float gloss, float shine) => new(null, 1f, false, false, false, through, gloss, shine);

    private static void AssertNear(float3 seen, float3 expected) =>
        Assert.That(math.cmax(math.abs(seen - expected)), Is.LessThan(1e-5f), $"{seen}, not {expected}");
}
