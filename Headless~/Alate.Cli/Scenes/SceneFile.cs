using System.Text.RegularExpressions;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Cli;

/// <summary>Unity's file of a sample scene, of which the light from all around counts.</summary>
internal static class SceneFile
{
    /// <summary>Gives the scene the light that its file says.</summary>
    public static void Apply(SampleScene scene)
    {
        string text = File.ReadAllText(Path.Combine(PackageRoot.Find(), "Samples~", scene.Folder, scene.Folder + ".unity"));
        RenderSettings.ambientMode = (AmbientMode)(int)Number(text, @"m_AmbientMode: (\d+)");
        RenderSettings.ambientSkyColor = Colour(text, "m_AmbientSkyColor");
        RenderSettings.ambientEquatorColor = Colour(text, "m_AmbientEquatorColor");
        RenderSettings.ambientGroundColor = Colour(text, "m_AmbientGroundColor");
    }

    private static Color Colour(string text, string name)
    {
        float Channel(string channel) => Number(text, $"{name}: {{[^}}]*{channel}: ([0-9.]+)");
        return new Color(Channel("r"), Channel("g"), Channel("b"));
    }

    private static float Number(string text, string pattern) =>
        float.Parse(Regex.Match(text, pattern).Groups[1].Value, CultureInfo.InvariantCulture);
}
