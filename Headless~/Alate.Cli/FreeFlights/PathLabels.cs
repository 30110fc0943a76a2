using System;
using System.Globalization;
using UnityEngine;

namespace Alate.Cli.FreeFlights;

/// <summary>Words and a scale bar on a picture of pixels, with letters five dots wide and seven high.</summary>
internal sealed class PathLabels(Color32[] pixels, int width)
{
    private const string k_Letters = "0123456789abcdefghijklmnopqrstuvwxyz.,";
    private const int k_Columns = 5, k_Rows = 7, k_Dot = 3, k_Margin = 24, k_BarHeight = 4;

    /// <summary>[letter] Five columns, each seven dots with the upper one first, as hexadecimal numbers.</summary>
    private const string k_Dots =
        "3E5149453E 00427F4000 4261514946 2141454B31 1814127F10 2745454539 3C4A494930 0171090503 3649494936 064949291E " +
        "2054545478 7F48444438 3844444420 384444487F 3854545418 087E090102 0C5252523E 7F08040478 00447D4000 2040443D00 7F10284400 00417F4000 7C04180478 7C08040478 3844444438 " +
        "7C14141408 081414187C 7C08040408 4854545420 043F444020 3C4020207C 1C2040201C 3C4030403C 4428102844 0C5050503C 4464544C44 0060600000 0050300000";

    private static readonly string[] s_Dots = k_Dots.Split(' ');
    private static readonly Color32 s_Ink = new Color32(0x33, 0x33, 0x33, 0xff);

    /// <summary>Writes a line in the upper left corner, lower case.</summary>
    public void Title(string text) => Write(text, k_Margin, k_Margin);

    /// <summary>Draws a bar of a round length, about a sixth of the width, in the lower left corner.</summary>
    /// <param name="pixelsPerMetre">Scale of the picture.</param>
    public void Scale(float pixelsPerMetre)
    {
        double wanted = width / 6.0 / pixelsPerMetre, power = Math.Pow(10, Math.Floor(Math.Log10(wanted)));
        double length = (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1) * power;
        int below = pixels.Length / width - k_Margin, bar = (int)Math.Round(length * pixelsPerMetre);
        Fill(k_Margin, below - k_BarHeight, bar, k_BarHeight);
        Fill(k_Margin, below - 3 * k_BarHeight, k_BarHeight, 2 * k_BarHeight);
        Fill(k_Margin + bar - k_BarHeight, below - 3 * k_BarHeight, k_BarHeight, 2 * k_BarHeight);
        string text = length < 0.01 ? (1000 * length).ToString("0.###", CultureInfo.InvariantCulture) + " mm"
            : length < 1 ? (100 * length).ToString("0.###", CultureInfo.InvariantCulture) + " cm" : length.ToString("0.###", CultureInfo.InvariantCulture) + " m";
        Write(text, k_Margin, below - 3 * k_BarHeight - (k_Rows + 2) * k_Dot);
    }

    private void Write(string text, int left, int top)
    {
        for (int k = 0; k < text.Length; k++)
        {
            int letter = k_Letters.IndexOf(text[k]);
            for (int column = 0; letter >= 0 && column < k_Columns; column++)
            {
                int dots = Convert.ToInt32(s_Dots[letter].Substring(2 * column, 2), 16);
                for (int row = 0; row < k_Rows; row++)
                {
                    if ((dots >> row & 1) != 0)
                        Fill(left + (k * (k_Columns + 1) + column) * k_Dot, top + row * k_Dot, k_Dot, k_Dot);
                }
            }
        }
    }

    private void Fill(int left, int top, int wide, int high)
    {
        for (int y = Math.Max(top, 0); y < Math.Min(top + high, pixels.Length / width); y++)
        {
            for (int x = Math.Max(left, 0); x < Math.Min(left + wide, width); x++)
                pixels[y * width + x] = s_Ink;
        }
    }
}
