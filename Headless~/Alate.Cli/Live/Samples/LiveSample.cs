using System.Text.Json.Nodes;
using System.Text.RegularExpressions;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Sample scene that plays for a page, which draws what the scene tells it: cameras, light, meshes and where they are.</summary>
internal sealed partial class LiveSample : IDisposable
{
    /// <summary>States a second.</summary>
    public const int Rate = 30;

    private const uint k_Magic = 0x53414c41, k_MostAhead = 3;

    private readonly PlayedSample m_Sample;
    private readonly SampleMeshes m_Meshes = new();
    private readonly SampleMaps m_Maps = new();
    private readonly SampleDraws m_Draws = new();
    private readonly (float Yaw, float Pitch, float Distance, Vector3 Target) m_Home;
    private string m_Panel = "";
    private double m_Time;
    private uint m_Number, m_Look, m_Seen;
    private bool m_IsPaused;

    /// <param name="scene">The sample.</param>
    public LiveSample(SampleScene scene)
    {
        m_Sample = new PlayedSample(scene);
        OrbitCamera orbit = m_Sample.Orbit;
        m_Home = (orbit.Yaw, orbit.Pitch, orbit.Distance, orbit.Target);
    }

    /// <summary>
    /// True while the page has not taken what it was sent: the scene waits for a page that is slow, as each state tells only what is new.
    /// </summary>
    public bool IsAhead => m_Number - m_Seen >= k_MostAhead;

    /// <summary>Message that the page gets first: the samples there are, and the one that plays.</summary>
    public JsonObject Hello() => new()
    {
        ["type"] = "hello",
        ["scene"] = m_Sample.Scene.Name,
        ["scenes"] = new JsonArray([.. SampleScene.All.Select(scene => new JsonObject
        {
            ["name"] = scene.Name,
            ["title"] = Title(scene),
        })]),
    };

    /// <summary>Takes what the page asks for.</summary>
    /// <exception cref="UserException">The panel has no such slider or button.</exception>
    public void Change(SampleRequest request)
    {
        m_IsPaused = request.IsPaused ?? m_IsPaused;
        m_Seen = Math.Clamp(request.Seen ?? m_Seen, m_Seen, m_Number);
        if (request.Aspect is { } aspect)
            Camera.main.aspect = (float)aspect;
        OrbitCamera orbit = m_Sample.Orbit;
        if (request.IsHome)
            (orbit.Yaw, orbit.Pitch, orbit.Distance, orbit.Target) = m_Home;
        if (request.Look is { } look)
        {
            orbit.Yaw += look.Yaw;
            orbit.Pitch += look.Pitch;
            orbit.Distance *= look.Zoom;
            orbit.Target += (Vector3)look.Move;
            m_Look = look.Number;
        }

        if (request.Slider.Name != null)
            m_Sample.Slide(request.Slider.Name, request.Slider.Value);
        if (request.Pressed != null)
            m_Sample.Press(request.Pressed);
    }

    /// <summary>Lets the time of a state pass and writes the state.</summary>
    public void Advance(StateBuffer state)
    {
        m_Sample.Step(m_IsPaused ? 0.0 : 1.0 / Rate);
        m_Time += m_IsPaused ? 0.0 : 1.0 / Rate;
        state.Clear();
        state.Add(k_Magic);
        state.Add(++m_Number);
        state.Add(m_Time);
        Write(state, Camera.main);
        Write(state, SceneReader.LightNow());
        m_Draws.Clear();
        foreach (SceneItem item in SceneItems.Of(Camera.main))
            m_Draws.Add(item, m_Meshes.See(item.Mesh), m_Maps);
        m_Meshes.Write(state);
        m_Maps.Write(state);
        m_Draws.Write(state);
    }

    /// <summary>The panel of the sample, where it is another one than when it was asked for last; else null.</summary>
    public JsonObject ChangedPanel()
    {
        JsonObject panel = SamplePanel.Describe(m_IsPaused);
        string text = panel.ToJsonString();
        if (text == m_Panel)
            return null;
        m_Panel = text;
        return panel;
    }

    public void Dispose() => m_Sample.Dispose();

    private void Write(StateBuffer state, Camera camera)
    {
        OrbitCamera orbit = m_Sample.Orbit;
        state.Add(m_Look);
        state.Add(orbit.Yaw);
        state.Add(orbit.Pitch);
        state.Add(orbit.Distance);
        state.Add((float3)orbit.Target);
        state.Add(camera.fieldOfView);
        state.Add(camera.nearClipPlane);
        state.Add(SceneReader.Behind(camera));
    }

    private static void Write(StateBuffer state, SceneLight light)
    {
        state.Add(light.Sky);
        state.Add(light.Equator);
        state.Add(light.Ground);
        state.Add(light.SunFrom);
        state.Add(light.Sun);
        state.Add(light.HasSun && light.HasShadows ? 1u : 0u);
        state.Add((uint)light.Lamps.Count);
        foreach (SceneLamp lamp in light.Lamps)
        {
            state.Add(lamp.Place);
            state.Add(lamp.Light);
            state.Add(lamp.Range);
        }
    }

    // "YourOwnWing" is "Your own wing".
    private static string Title(SampleScene scene) => Inside().Replace(scene.Folder, part => " " + part.Value.ToLowerInvariant());

    [GeneratedRegex("(?<=.)[A-Z]")]
    private static partial Regex Inside();
}
