using Engraver.Core.Drawings;
using Engraver.Core.TextMarkup;
using Engraver.Fonts.Finding;

namespace Engraver.Workbench.Lettering;

/// <summary>The fonts of a drawing's texts: a style or a code of an MTEXT names a font, the library finds it or a substitute.</summary>
/// <param name="styles">The styles of the drawing.</param>
/// <param name="library">The fonts beside the drawing, of the program and of the system.</param>
/// <param name="faults">Lines of the user's substitution tables that cannot be read.</param>
public sealed class LetterFonts(IReadOnlyList<TextStyle> styles, FontLibrary library, IReadOnlyList<SubstituteFault> faults)
{
    private readonly Dictionary<FontRequest, FoundFont> _used = [];

    /// <summary>The stroke font of this program.</summary>
    public static FoundFont BuiltIn { get; } = new FontLibrary([], FontSubstitutes.Standard).Find(new FontRequest("engraver", "", IsBold: false, IsItalic: false));

    /// <summary>Lines of the user's substitution tables that cannot be read.</summary>
    public IReadOnlyList<SubstituteFault> Faults => faults;

    /// <summary>The fonts that have been asked for, in the order of the first request.</summary>
    public IEnumerable<FoundFont> Used => _used.Values;

    /// <summary>The style of a name, in any case; a style without a font for a name that the drawing does not define.</summary>
    public TextStyle StyleOf(string name) => styles.FirstOrDefault(style => string.Equals(style.Name, name, StringComparison.OrdinalIgnoreCase)) ?? new TextStyle(name);

    public FoundFont Of(TextStyle style)
    {
        ArgumentNullException.ThrowIfNull(style);
        return Find(new FontRequest(style.FontFile, style.Family, style.IsBold, style.IsItalic));
    }

    public FoundFont Of(MTextFont font)
    {
        ArgumentNullException.ThrowIfNull(font);
        return Find(font.IsShape ? new FontRequest(font.Name, "", IsBold: false, IsItalic: false) : new FontRequest("", font.Name, font.IsBold, font.IsItalic));
    }

    private FoundFont Find(FontRequest request)
    {
        if (!_used.TryGetValue(request, out var found)) _used[request] = found = library.Find(request);
        return found;
    }
}
