using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Tests.Views
{
    /// <summary>A state of the live view as a page reads it, by the layout that the page's format.js names.</summary>
    internal sealed class ViewState
    {
        public ViewState(byte[] bytes)
        {
            int at = 24;
            float Number() => BitConverter.ToSingle(bytes, (at += 4) - 4);
            int Whole() => BitConverter.ToInt32(bytes, (at += 4) - 4);
            float3 Vector() => new float3(Number(), Number(), Number());

            Magic = BitConverter.ToUInt32(bytes, 0);
            Columns = BitConverter.ToInt32(bytes, 4);
            Time = BitConverter.ToDouble(bytes, 8);
            HasWake = BitConverter.ToUInt32(bytes, 20) == 1;
            for (int column = 0; column < Columns; column++)
            {
                float phase = Number();
                double beats = Whole() + phase / (2.0 * Math.PI);
                Beats.Add(beats);
                Hertz.Add(Number());
                Lift.Add(Number());
                Drag.Add(Number());
                Flap.Add(Number());
                Abdomen.Add(Number());
                Substeps.Add(Whole());
                var wings = new List<Wing>();
                for (int left = Whole(); left > 0; left--)
                {
                    int vertices = Whole(), joints = Whole();
                    var wing = new Wing { Reach = Number(), Force = Vector() };
                    for (int k = 0; k < joints; k++)
                        wing.Joints.Add(Vector());
                    for (int k = 0; k < joints; k++)
                        wing.Loads.Add(Vector());
                    for (int k = 0; k < vertices; k++, at += 8)
                    {
                        wing.Places.Add(wing.Reach / short.MaxValue * new float3(
                            BitConverter.ToInt16(bytes, at), BitConverter.ToInt16(bytes, at + 2), BitConverter.ToInt16(bytes, at + 4)));
                        wing.StretchPct.Add(bytes[at + 6] / 10f);
                        wing.Attack.Add(bytes[at + 7]);
                    }

                    at += 4 * vertices;
                    wings.Add(wing);
                }

                Wings.Add(wings);
                var sheets = new List<Sheet>();
                for (int left = HasWake ? Whole() : 0; left > 0; left--)
                {
                    int rows = Whole();
                    var sheet = new Sheet { Width = Whole(), Reach = Number(), Strongest = Number() };
                    for (int k = 0; k < rows * sheet.Width; k++, at += 8)
                    {
                        short Part(int part) => BitConverter.ToInt16(bytes, at + 2 * part);
                        sheet.Places.Add(sheet.Reach / short.MaxValue * new float3(Part(0), Part(1), Part(2)));
                        sheet.Circulation.Add(sheet.Strongest / short.MaxValue * Part(3));
                    }

                    sheets.Add(sheet);
                }

                Sheets.Add(sheets);
            }

            Length = at;
        }

        public uint Magic { get; }

        public int Columns { get; }

        public double Time { get; }

        /// <summary>True where it says that it has wakes.</summary>
        public bool HasWake { get; }

        /// <summary>Bytes that were read.</summary>
        public int Length { get; }

        public List<double> Beats { get; } = new List<double>();

        public List<float> Hertz { get; } = new List<float>();

        public List<float> Lift { get; } = new List<float>();

        public List<float> Drag { get; } = new List<float>();

        public List<float> Flap { get; } = new List<float>();
        public List<float> Abdomen { get; } = new List<float>();

        public List<int> Substeps { get; } = new List<int>();

        public List<List<Wing>> Wings { get; } = new List<List<Wing>>();

        /// <summary>[column] Rings behind each wing; empty before the first are done.</summary>
        public List<List<Sheet>> Sheets { get; } = new List<List<Sheet>>();

        internal sealed class Sheet
        {
            /// <summary>Points of a row.</summary>
            public int Width { get; set; }

            public float Reach { get; set; }

            public float Strongest { get; set; }

            /// <summary>[row · width + point] Metres.</summary>
            public List<float3> Places { get; } = new List<float3>();

            /// <summary>[row · width + point] m²/s.</summary>
            public List<float> Circulation { get; } = new List<float>();
        }

        internal sealed class Wing
        {
            public float Reach { get; set; }

            public float3 Force { get; set; }

            public List<float3> Joints { get; } = new List<float3>();

            public List<float3> Loads { get; } = new List<float3>();

            public List<float3> Places { get; } = new List<float3>();

            public List<float> StretchPct { get; } = new List<float>();

            public List<int> Attack { get; } = new List<int>();
        }
    }
}
