using System.Text.Json;

namespace Alate.Cli;

/// <summary>summary.json: the numbers of the main wing, the flight's, and what was asked for.</summary>
internal static class SummaryJson
{
    public static void Write(FlightSummary summary, Stream stream)
    {
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        json.WriteStartObject();
        json.WriteString("species", summary.Flight.Insect.Name);
        WriteWing(json, summary.Main, summary.Flight.Plan.Variant);
        Number(json, "lift_over_weight", summary.LiftOverWeight);
        Vector(json, "mean_force_n", summary.MeanForce);
        Vector(json, "mean_moment_n_m", summary.MeanMoment);
        Number(json, "power_w", summary.MeanPower.Air);
        Number(json, "positive_power_w", summary.MeanPower.Positive);
        Number(json, "negative_power_w", summary.MeanPower.Negative);
        if (summary.Flight.Plan.Induced != null)
            Vector(json, "induced_velocity_m_s", summary.Flight.InducedVelocity);
        Number(json, "newton_iterations_mean", summary.NewtonIterationsMean);
        json.WriteNumber("resets", summary.Resets);
        Number(json, "us_per_substep", summary.Flight.MicrosecondsPerSubstep);
        json.WriteNumber("triangles", summary.Triangles);
        Number(json, "beats", summary.Flight.Beats);
        Number(json, "seconds", summary.Flight.Seconds);
        WriteOtherWings(json, summary);
        PlausibilityJson.Write(json, summary.Plausibility);
        WriteOptions(json, summary.Flight);
        RunJson.Write(json, summary.Flight.Plan.Record, summary.Flight.Plan.Definition);
        json.WriteEndObject();
        json.Flush();
        stream.WriteByte((byte)'\n');
    }

    private static void WriteWing(Utf8JsonWriter json, WingSummary wing, InsectVariant variant)
    {
        json.WriteString("wing", wing.Name);
        foreach (WingMeasure measure in WingMeasure.All)
            Number(json, measure.Key, measure.Of(wing));
        Number(json, "leading_ei_n_m2", wing.Stiffness.Leading);
        Number(json, "wing_ei_n_m2", wing.Stiffness.Whole);
        Number(json, "usual_ei_n_m2", wing.Stiffness.Usual);
        json.WriteStartArray("outside_usual");
        foreach (MeasureBound bound in MeasureBound.All)
        {
            if (!bound.Holds(wing, variant))
                json.WriteStringValue(bound.Key);
        }

        json.WriteEndArray();
    }

    private static void WriteOtherWings(Utf8JsonWriter json, FlightSummary summary)
    {
        if (summary.Wings.Count == 1)
            return;
        json.WriteStartArray("other_wings");
        for (int k = 1; k < summary.Wings.Count; k++)
        {
            json.WriteStartObject();
            WriteWing(json, summary.Wings[k], summary.Flight.Plan.Variant);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteOptions(Utf8JsonWriter json, FlightRecord flight)
    {
        FlightPlan plan = flight.Plan;
        WingParameters parameters = flight.Wings[0].Parameters;
        json.WriteStartObject("options");
        json.WriteNumber("speed_m_s", plan.Speed);
        json.WriteNumber("climb_m_s", plan.Climb);
        json.WriteNumber("pitch_deg", plan.PitchDegrees);
        if (plan.Seconds is double seconds)
            json.WriteNumber("seconds", seconds);
        if (plan.KinematicsFile != null)
            json.WriteString("kinematics", plan.KinematicsFile);
        json.WriteStartArray("wind_m_s");
        foreach (double component in plan.Wind)
            json.WriteNumberValue(component);
        json.WriteEndArray();
        if (plan.Induced != null)
            json.WriteNumber("induced_flow", plan.Induced.Factor);
        if (parameters.options.addedMass)
            json.WriteBoolean("added_mass", true);
        Number(json, "lag", parameters.chordDelay);
        json.WriteNumber("elasticity_factor", plan.Elasticity);
        json.WriteNumber("substeps", parameters.substepsPerBeat);
        if (plan.Patches == 0)
            json.WriteString("elements", "triangles");
        else
            json.WriteNumber("elements", plan.Patches);
        json.WriteString("coefficients", parameters.options.coefficients.ToString().ToLowerInvariant());
        json.WriteString("preset", plan.Preset.ToString().ToLowerInvariant());
        json.WriteString("variant", plan.Variant.ToString().ToLowerInvariant());
        json.WriteBoolean("no_wave", plan.Column == ComparisonColumn.NoWave);
        json.WriteBoolean("rigid", plan.Column == ComparisonColumn.RigidWing);
        if (plan.MeshFile != null)
        {
            json.WriteString("mesh", plan.MeshFile);
            json.WriteString("skeleton", plan.SkeletonFile);
            if (plan.HindMeshFile != null)
            {
                json.WriteString("hind_mesh", plan.HindMeshFile);
                json.WriteString("hind_skeleton", plan.HindSkeletonFile);
            }

            json.WriteString("parameters_of", plan.Species);
        }

        json.WriteEndObject();
    }

    private static void Vector(Utf8JsonWriter json, string key, Unity.Mathematics.float3 value)
    {
        json.WriteStartArray(key);
        foreach (double component in new[] { value.x, value.y, value.z })
            WriteNumber(json, component);
        json.WriteEndArray();
    }

    // Six significant digits: more are noise of single precision.
    internal static void Number(Utf8JsonWriter json, string key, double value)
    {
        json.WritePropertyName(key);
        WriteNumber(json, value);
    }

    private static void WriteNumber(Utf8JsonWriter json, double value)
    {
        if (!double.IsFinite(value))
        {
            json.WriteNullValue();
            return;
        }

        double magnitude = value == 0.0 ? 0.0 : Math.Floor(Math.Log10(Math.Abs(value)));
        json.WriteNumberValue(Math.Round(value, (int)Math.Clamp(5.0 - magnitude, 0.0, 15.0)));
    }
}
