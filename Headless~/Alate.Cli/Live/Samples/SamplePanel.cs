using System.Text.Json.Nodes;
using StandIns;

namespace Alate.Cli;

/// <summary>Panel of a sample, as the page shows it: texts, sliders, buttons and toggles in their order, with their rows.</summary>
internal static class SamplePanel
{
    /// <summary>The panel as it was drawn last.</summary>
    /// <param name="isPaused">True while the scene stands still.</param>
    public static JsonObject Describe(bool isPaused)
    {
        var controls = new JsonArray();
        using IEnumerator<DrawnSlider> sliders = DrawnScreen.Sliders.GetEnumerator();
        IReadOnlyList<DrawnControl> drawn = DrawnScreen.Controls;
        int row = 0;
        for (int k = 0; k < drawn.Count; k++)
        {
            // The label of a slider stands before it.
            bool isLabelOfNext = k + 1 < drawn.Count && drawn[k + 1].Kind == ControlKind.Field && drawn[k + 1].Text == drawn[k].Text;
            row += k > 0 && drawn[k].Place.yMin > drawn[k - 1].Place.yMin ? 1 : 0;
            if (!isLabelOfNext)
                controls.Add(Describe(drawn[k], sliders, row));
        }

        return new JsonObject { ["type"] = "panel", ["paused"] = isPaused, ["controls"] = controls };
    }

    private static JsonNode Describe(DrawnControl control, IEnumerator<DrawnSlider> sliders, int row)
    {
        var told = new JsonObject { ["kind"] = "label", ["text"] = control.Text, ["row"] = row };
        switch (control.Kind)
        {
            case ControlKind.Button:
                told["kind"] = "button";
                break;
            case ControlKind.Field:
                sliders.MoveNext();
                told["kind"] = "slider";
                told["name"] = PlayedSample.NameOf(control.Text);
                told["value"] = sliders.Current.Value;
                told["min"] = sliders.Current.Left;
                told["max"] = sliders.Current.Right;
                break;
            case ControlKind.Toggle:
                told["kind"] = "toggle";
                told["on"] = control.Value == bool.TrueString;
                break;
        }

        return told;
    }
}
