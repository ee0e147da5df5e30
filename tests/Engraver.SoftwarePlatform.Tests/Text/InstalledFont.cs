using Avalonia.Media;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>Faces of the installed fonts, read without an application.</summary>
internal static class InstalledFont
{
    public const string Arabic = "DejaVu Sans";
    public const string Devanagari = "Lohit Devanagari";
    public const string Bengali = "Lohit Bengali";
    public const string Tamil = "Lohit Tamil";
    public const string Thai = "Garuda";

    private static readonly SoftwareFontManager s_manager = new();

    public static SoftwareTypeface? TryFind(string family) =>
        s_manager.TryCreateGlyphTypeface(family, FontStyle.Normal, FontWeight.Normal, FontStretch.Normal, out var typeface) ? (SoftwareTypeface)typeface : null;
}
