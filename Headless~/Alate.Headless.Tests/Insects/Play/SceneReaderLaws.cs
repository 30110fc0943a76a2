using System.Collections;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>Cameras and lights of a scene, as its pictures have them.</summary>
public sealed class SceneReaderLaws : PlayFixture
{
    [UnityTest]
    public IEnumerator ACamera_PutsEachPlace_WhereUnityDoes()
    {
        Camera camera = Keep(new GameObject("camera")).AddComponent<Camera>();
        camera.transform.SetPositionAndRotation(new Vector3(3f, 2f, -5f), Quaternion.Euler(20f, 30f, 10f));
        camera.fieldOfView = 47f;
        yield return null;

        var size = new int2(320, 180);
        SceneCamera read = new SceneReader().Shot(camera, size).Camera;
        foreach (float3 seen in new[] { new float3(0f, 0f, 4f), new float3(1f, -0.5f, 6f), new float3(-2f, 1.5f, 9f) })
        {
            Vector3 place = camera.transform.TransformPoint(seen), wanted = camera.WorldToViewportPoint(place);
            float2 found = read.Project(read.Seen(place)) / size;
            Assert.That(math.distance(found, new float2(wanted.x, 1f - wanted.y)), Is.LessThan(1e-4f), $"{seen}");
        }
    }

    [UnityTest]
    public IEnumerator Lights_AreThoseThatShine_FromWhereTheyAre()
    {
        Camera camera = Keep(new GameObject("camera")).AddComponent<Camera>();
        Light sun = Made(LightType.Directional), lamp = Made(LightType.Point), off = Made(LightType.Point);
        sun.transform.rotation = Quaternion.Euler(30f, 90f, 0f);
        sun.color = new Color(1f, 0.5f, 0f);
        sun.intensity = 0.5f;
        lamp.transform.position = new Vector3(1f, 2f, 3f);
        lamp.range = 4f;
        off.enabled = false;
        yield return null;

        SceneLight read = new SceneReader().Shot(camera, new int2(16, 9)).Light;
        Assert.That(math.distance(read.SunFrom, new float3(-math.cos(math.radians(30f)), 0.5f, 0f)), Is.LessThan(1e-5f));
        Assert.That(math.distance(read.Sun, 0.5f * Shading.ToLinear(new float3(1f, 0.5f, 0f))), Is.LessThan(1e-5f));
        Assert.That(read.HasShadows, Is.False);
        Assert.That(read.Lamps, Is.EqualTo(new[] { new SceneLamp(new float3(1f, 2f, 3f), 1f, 4f) }));

        sun.shadows = LightShadows.Soft;
        Assert.That(new SceneReader().Shot(camera, new int2(16, 9)).Light.HasShadows);
        sun.gameObject.SetActive(false);
        Assert.That(new SceneReader().Shot(camera, new int2(16, 9)).Light.HasSun, Is.False);
    }

    private Light Made(LightType type)
    {
        Light light = Keep(new GameObject(type.ToString())).AddComponent<Light>();
        light.type = type;
        return light;
    }
}
