using Alate.Fitting;
using UnityEngine;

namespace Alate.Cli;

/// <summary>A fitted skeleton over the outline of its wing, seen from above with the leading edge upwards, as SVG.</summary>
internal sealed class SkeletonPicture
{
    private const float k_Width = 900f, k_Margin = 40f;

    // From the leading to the trailing chain.
    private static readonly string[] s_Colours = ["#b3261e", "#d97706", "#4d7c0f", "#0e7490", "#6d28d9"];

    private readonly StringBuilder m_Svg = new();
    private readonly float3 m_Right, m_Ahead;
    private readonly float2 m_Low;
    private readonly float m_Scale, m_Height;

    private SkeletonPicture(SkeletonFit fit)
    {
        WingSkeleton skeleton = fit.Skeleton;
        float3 span = math.normalize(skeleton.SpanAxis), up = math.normalize(skeleton.UpAxis);
        m_Right = span;
        m_Ahead = math.normalize(math.cross(span, up));
        float3 first = skeleton.GetJoint(0, skeleton.JointsPerChain - 1);
        float3 last = skeleton.GetJoint(skeleton.ChainCount - 1, skeleton.JointsPerChain - 1);
        m_Ahead = math.dot(first - last, m_Ahead) < 0f ? -m_Ahead : m_Ahead;

        m_Low = float.MaxValue;
        float2 high = float.MinValue;
        foreach (Vector3 point in fit.Outline)
        {
            m_Low = math.min(m_Low, Plan(point));
            high = math.max(high, Plan(point));
        }

        m_Scale = (k_Width - 2f * k_Margin) / math.max(high.x - m_Low.x, high.y - m_Low.y);
        m_Height = (high.y - m_Low.y) * m_Scale + 2f * k_Margin;
    }

    /// <summary>The picture.</summary>
    public static string Draw(SkeletonFit fit)
    {
        var picture = new SkeletonPicture(fit);
        picture.Append($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {k_Width:0.#} {picture.m_Height:0.#}\">\n");
        picture.Append($"<rect width=\"{k_Width:0.#}\" height=\"{picture.m_Height:0.#}\" fill=\"#ffffff\"/>\n");
        picture.DrawWing(fit);
        for (int i = 0; i < fit.Skeleton.ChainCount; i++)
            picture.DrawChain(fit.Skeleton, i);
        picture.DrawHinge(fit.Skeleton.Hinge);
        picture.m_Svg.Append("</svg>\n");
        return picture.m_Svg.ToString();
    }

    private void DrawWing(SkeletonFit fit)
    {
        IEnumerable<string> loops = fit.Holes.Prepend(fit.Outline).Select(loop => $"M{Points(loop)}Z");
        m_Svg.Append("<path fill=\"#eef2f7\" fill-rule=\"evenodd\" stroke=\"#475569\" stroke-width=\"1.5\" d=\"");
        m_Svg.AppendJoin(' ', loops).Append("\"/>\n");
    }

    private void DrawChain(WingSkeleton skeleton, int chain)
    {
        string colour = s_Colours[chain * (s_Colours.Length - 1) / (skeleton.ChainCount - 1)];
        Vector3[] joints = skeleton.Chains[chain].joints;
        m_Svg.Append($"<polyline fill=\"none\" stroke=\"{colour}\" stroke-width=\"3\" points=\"{Points(joints)}\"/>\n");
        foreach (Vector3 joint in joints)
        {
            float2 at = At(joint);
            Append($"<circle cx=\"{at.x:0.#}\" cy=\"{at.y:0.#}\" r=\"5\" fill=\"{colour}\"/>\n");
        }
    }

    private void DrawHinge(Vector3 hinge)
    {
        float2 at = At(hinge);
        Append($"<circle cx=\"{at.x:0.#}\" cy=\"{at.y:0.#}\" r=\"11\" fill=\"none\" stroke=\"#0f172a\" stroke-width=\"2.5\"/>\n");
    }

    private string Points(IEnumerable<Vector3> points) => string.Join(' ', points.Select(point =>
    {
        float2 at = At(point);
        return string.Create(CultureInfo.InvariantCulture, $"{at.x:0.#},{at.y:0.#}");
    }));

    private float2 At(Vector3 point)
    {
        float2 from = (Plan(point) - m_Low) * m_Scale;
        return new float2(k_Margin + from.x, m_Height - k_Margin - from.y);
    }

    private float2 Plan(Vector3 point) => new(math.dot(m_Right, point), math.dot(m_Ahead, point));

    private void Append(FormattableString text) => m_Svg.Append(text.ToString(CultureInfo.InvariantCulture));
}
