using System.Collections.Concurrent;
using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.Fonts.OpenType;
using FontStyle = Avalonia.Media.FontStyle;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Inter, which is part of the program, is the default; installed fonts are used for other families and for characters that Inter does not
/// have.</summary>
public sealed class SoftwareFontManager : IFontManagerImpl
{
    private const string DefaultFamily = "fonts:Inter#Inter";
    private const int WrongStyle = 2000;
    private const int WrongStretchStep = 100;
    private const int LightestBold = 600;

    private readonly InstalledFonts _installed;
    private readonly ConcurrentDictionary<(SoftwareTypeface Face, FontSimulations Simulations), SoftwareTypeface?> _simulated = new();

    public SoftwareFontManager()
        : this(FontFolders.Standard)
    {
    }

    internal SoftwareFontManager(IReadOnlyList<string> fontFolders) => _installed = new InstalledFonts(fontFolders);

    public string GetDefaultFontFamilyName() => DefaultFamily;

    public string[] GetInstalledFontFamilyNames(bool checkForUpdates = false) => [.. _installed.FamilyNames];

    public bool TryMatchCharacter(
        int codepoint,
        FontStyle fontStyle,
        FontWeight fontWeight,
        FontStretch fontStretch,
        string? familyName,
        CultureInfo? culture,
        [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        var able = _installed.Faces.Where(face => face.GlyphTypeface.CharacterToGlyphMap.ContainsGlyph(codepoint));
        platformTypeface = able.MinBy(face => Distance(face, fontStyle, fontWeight, fontStretch));
        return platformTypeface is not null;
    }

    public bool TryCreateGlyphTypeface(
        string familyName,
        FontStyle style,
        FontWeight weight,
        FontStretch stretch,
        [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        var nearest = _installed.Family(familyName).MinBy(face => Distance(face, style, weight, stretch));
        platformTypeface = nearest is null ? null : Simulated(nearest, style, weight);
        return platformTypeface is not null;
    }

    public bool TryCreateGlyphTypeface(Stream stream, FontSimulations fontSimulations, [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        platformTypeface = SoftwareTypeface.TryCreate(new MemoryFontSource(Whole(stream)), 0, fontSimulations);
        return platformTypeface is not null;
    }

    public bool TryGetFamilyTypefaces(string familyName, [NotNullWhen(true)] out IReadOnlyList<Typeface>? familyTypefaces)
    {
        familyTypefaces = [.. _installed.Family(familyName).Select(face => new Typeface(familyName, face.Style, face.Weight, face.Stretch))];
        return familyTypefaces.Count > 0;
    }

    /// <summary>Copied only once if its length is known, as for a font in an assembly, because the fonts of the window are read at each start.</summary>
    private static byte[] Whole(Stream stream)
    {
        if (!stream.CanSeek)
        {
            using var memory = new MemoryStream();
            stream.CopyTo(memory);
            return memory.ToArray();
        }

        var bytes = GC.AllocateUninitializedArray<byte>((int)(stream.Length - stream.Position));
        stream.ReadExactly(bytes);
        return bytes;
    }

    private SoftwareTypeface Simulated(SoftwareTypeface face, FontStyle style, FontWeight weight)
    {
        var simulations = FontSimulations.None;
        if ((int)weight >= LightestBold && (int)face.Weight < LightestBold)
            simulations |= FontSimulations.Bold;
        if (style != FontStyle.Normal && face.Style == FontStyle.Normal)
            simulations |= FontSimulations.Oblique;
        if (simulations == FontSimulations.None)
            return face;
        return _simulated.GetOrAdd((face, simulations), key => key.Face.TrySimulate(key.Simulations)) ?? face;
    }

    private static int Distance(SoftwareTypeface face, FontStyle style, FontWeight weight, FontStretch stretch) =>
        Math.Abs((int)face.Weight - (int)weight)
        + (face.Style == style ? 0 : WrongStyle)
        + WrongStretchStep * Math.Abs((int)face.Stretch - (int)stretch);
}
