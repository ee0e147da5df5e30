using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using Engraver.Fonts.Strokes;

namespace Engraver.Fonts.Finding;

/// <summary>The fonts of the program, by their names.</summary>
internal static class ProgramFonts
{
    private static readonly Lazy<OpenedFont> s_engraver = new(() => new(StrokeFont.Engraver, null, HashOfData("")));

    /// <summary>Its shapes follow from the same data and its width.</summary>
    private static readonly Lazy<OpenedFont> s_double = new(() => new(DoubleStrokeFont.Engraver, null, HashOfData(DoubleStrokeFont.Engraver.Width.ToString(CultureInfo.InvariantCulture))));

    public static OpenedFont Engraver => s_engraver.Value;

    /// <returns>Null for another name.</returns>
    public static OpenedFont? Named(string name) => SubstituteTable.KeyOf(name).ToUpperInvariant() switch
    {
        "ENGRAVER" => Engraver,
        "ENGRAVER-DOUBLE" => s_double.Value,
        _ => null,
    };

    private static string HashOfData(string parameters)
    {
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach (var name in StrokeFont.DataFiles)
        {
            using var data = StrokeFont.OpenData(name);
            var bytes = new byte[data.Length];
            data.ReadExactly(bytes);
            hash.AppendData(bytes);
        }

        hash.AppendData(Encoding.UTF8.GetBytes(parameters));
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }
}
