using System.Globalization;
using Alate.Flight;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>State of a flight as the inspector tells it: one line, and what is the matter.</summary>
    internal readonly struct FlightStatus
    {
        private FlightStatus(FlightFault fault, string message)
        {
            Fault = fault;
            Message = message;
        }

        /// <summary>Fault that was found.</summary>
        public FlightFault Fault { get; }

        /// <summary>Line for the user; empty where there is nothing to say.</summary>
        public string Message { get; }

        /// <summary>Severity of the line.</summary>
        public MessageType Kind => Fault == FlightFault.None || Fault == FlightFault.NoPilot ? MessageType.Info : MessageType.Warning;

        /// <summary>Finds the first thing that is the matter; in play, how the insect flies.</summary>
        public static FlightStatus Of(InsectFlight flight)
        {
            FlightFault fault = FindFault(flight);
            return new FlightStatus(fault, fault == FlightFault.None ? Flying(flight) : MessageOf(fault));
        }

        private static FlightFault FindFault(InsectFlight flight)
        {
            if (InsectStatus.Of(flight.GetComponent<InsectWings>()).Problem.IsProblem)
                return FlightFault.Wings;
            if (flight.Parts.Count == 0)
                return FlightFault.NoBody;
            if (flight.Trims == null)
                return FlightFault.NoTrims;
            switch (flight.Problem)
            {
                case FlightProblem.BadBody: return FlightFault.BadBody;
                case FlightProblem.NoTrims: return FlightFault.NoTrims;
                case FlightProblem.OtherNumbers: return FlightFault.OtherNumbers;
            }

            if (flight.HasPilotFailed)
                return FlightFault.PilotFailed;
            return flight.Pilot == null && !flight.TryGetComponent(out FlightPilot _) ? FlightFault.NoPilot : FlightFault.None;
        }

        private static string MessageOf(FlightFault fault)
        {
            switch (fault)
            {
                case FlightFault.Wings: return "Does not fly: its wings have a problem; see Insect Wings.";
                case FlightFault.NoBody:
                    return "Does not fly: its body has no parts. Take those of a monarch, at the size of these wings, "
                    + "and adapt them; then bake trims.";
                case FlightFault.BadBody:
                    return "Does not fly: its masses or the parts of its body are not possible. The console says which.";
                case FlightFault.NoTrims:
                    return "Does not fly: it has no trims. Bake them, or take an insect of GameObject > Alate > Flying.";
                case FlightFault.OtherNumbers:
                    return "Does not fly: its trims were made for other numbers of preset or body. Take the "
                    + "preset for which they were made, or bake trims.";
                case FlightFault.PilotFailed:
                    return "Hovers: its pilot threw an exception; see the console. Mend the pilot, then disable and enable it.";
                default: return "No pilot: the insect keeps the velocity that a script sets, and hovers without one.";
            }
        }

        private static string Flying(InsectFlight flight)
        {
            if (!Application.isPlaying || flight.Limits.TopSpeed <= 0f)
                return "";
            string line = string.Format(
                CultureInfo.InvariantCulture, "{0}, {1:0.00} m/s, aid {2:0.00} mW", flight.State, flight.BodyVelocity.magnitude,
                1000f * flight.AidPower);
            line += Tumbles(flight);
            if (!flight.TryReadTrim(out WingDrive drive, out Vector3 wanted))
                return line;
            return line + string.Format(
                CultureInfo.InvariantCulture, "\nWanted {0:0.00} m/s. Trim: {1:0.0} Hz, amplitude {2:0.00}, tilt {3:0}°, sweep {4:0}°",
                wanted.magnitude, drive.frequency,
                drive.amplitude, Mathf.Rad2Deg * drive.tilt, Mathf.Rad2Deg * drive.meanSweep);
        }

        private static string Tumbles(InsectFlight flight)
        {
            FlightTumble last = flight.Tumble;
            string times = flight.TumbleCount == 1 ? "once" : $"{flight.TumbleCount} times";
            return flight.TumbleCount == 0 ? "" : string.Format(
                CultureInfo.InvariantCulture, "\nTumbled {0}, the last time at {1:0.0} s for {2:0.00} s and {3:0.00} m", times, last.time,
                last.seconds, last.distance);
        }
    }
}
