using System.Text.RegularExpressions;
using Alate.Showcase;
using StandIns;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Sample scene that plays as after pressing Play, in frames that are as long as they are told.</summary>
internal sealed class PlayedSample : IDisposable
{
    /// <summary>Longest frame of the game, seconds.</summary>
    private const double k_Frame = 1.0 / 60.0;

    private readonly SceneReader m_Reader = new();

    /// <param name="scene">The sample.</param>
    public PlayedSample(SampleScene scene)
    {
        Scene = scene;
        SceneFile.Apply(scene);
        ProjectShaders.Add(WingMaterial.ShaderName, WingMaterial.ShaderName);
        PlayerLoop.EnterPlayMode();
        new GameObject(scene.Script.Name).AddComponent(scene.Script);
        Step(2.0 * k_Frame);
    }

    /// <summary>The sample.</summary>
    public SampleScene Scene { get; }

    /// <summary>The camera of the sample, which turns about a point.</summary>
    public OrbitCamera Orbit => Camera.main.GetComponent<OrbitCamera>();

    /// <summary>Lets time go by, seconds: one frame of the game where it is short, else several.</summary>
    public void Step(double seconds)
    {
        int frames = Math.Max((int)Math.Ceiling(seconds / k_Frame - 1e-6), 1);
        for (int frame = 0; frame < frames; frame++)
        {
            // Those of the last frame are seen.
            DrawnInstances.Calls = frame == frames - 1 ? [] : null;
            PlayerLoop.Tick((float)(seconds / frames));
        }
    }

    /// <summary>Moves a slider of the sample's own panel, or presses one of its buttons.</summary>
    /// <param name="setting">How the slider's label begins, an equals sign and a value; or the words of the button.</param>
    /// <exception cref="UserException">The panel has none, or the value is none of it.</exception>
    public void Set(string setting)
    {
        int at = setting.LastIndexOf('=');
        if (at < 0)
        {
            Press(setting);
            return;
        }

        string name = setting[..at].Trim(), value = setting[(at + 1)..].Trim();
        if (!double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) || !double.IsFinite(number))
            throw new UserException($"{Quote.Of(name)} takes a finite number, not {Quote.Of(value)}.");
        Slide(name, number);
    }

    /// <summary>Moves a slider of the sample's own panel.</summary>
    /// <param name="name">Beginning of its label.</param>
    /// <param name="value">Number between those of its ends.</param>
    /// <exception cref="UserException">The panel has none, or the value is out of its range.</exception>
    public void Slide(string name, double value)
    {
        DrawnSlider slider = DrawnScreen.Sliders.FirstOrDefault(one => Begins(one.Label, name)) ?? throw Unknown(name);
        if (value < slider.Left || value > slider.Right)
        {
            throw new UserException(FormattableString.Invariant(
                $"{Quote.Of(name)} must lie between {slider.Left} and {slider.Right}; it is {value}."));
        }

        DrawnScreen.Slide(slider.Label[..name.Length], (float)value);
        Settle();
    }

    /// <summary>Presses a button or toggle of the sample's own panel.</summary>
    /// <param name="name">Beginning of its words.</param>
    /// <exception cref="UserException">The panel has none.</exception>
    public void Press(string name)
    {
        DrawnControl found = DrawnScreen.Controls.FirstOrDefault(
            control => control.Kind is ControlKind.Button or ControlKind.Toggle && Begins(control.Text, name)) ?? throw Unknown(name);
        DrawnScreen.Press(found.Text);
        Settle();
    }

    /// <summary>Name of a slider by its label: what that says besides begins with a colon, a factor or a number.</summary>
    public static string NameOf(string label) => Regex.Match(label, @"^[^:×\d]*").Value.Trim(' ', '-');

    /// <summary>Shot of what the main camera of the scene sees now.</summary>
    /// <param name="size">Columns and rows of the picture.</param>
    public SceneShot Shot(int2 size) => m_Reader.Shot(Camera.main, size);

    /// <summary>Ends the scene.</summary>
    public void Dispose()
    {
        DrawnInstances.Calls = null;
        PlayerLoop.ExitPlayMode();
        ProjectShaders.Clear();
    }

    private void Settle()
    {
        while (DrawnScreen.IsBusy)
            Step(0.0);
        Step(0.0);
    }

    private UserException Unknown(string name)
    {
        string[] sliders = [.. DrawnScreen.Sliders.Select(slider => $"{NameOf(slider.Label)}=VALUE")];
        string[] buttons = [.. DrawnScreen.Controls.Where(control => control.Kind is ControlKind.Button or ControlKind.Toggle)
            .Select(control => control.Text)];
        return new UserException($"The panel of {Scene.Name} has nothing named {Quote.Of(name)}. "
            + (sliders.Length + buttons.Length == 0 ? "It is empty." : $"It has: {string.Join(", ", [.. sliders, .. buttons])}."));
    }

    private static bool Begins(string text, string name) =>
        name.Length > 0 && text.StartsWith(name, StringComparison.OrdinalIgnoreCase);
}
