using System.Globalization;
using System.Reflection;
using System.Resources;

namespace Engraver.Core.Languages;

/// <summary>The texts of one project in the language of <see cref="CultureInfo.CurrentUICulture"/>, from its <c>Texts.resx</c>, which is English, or from the
/// language's own file (<see cref="LanguageFile"/>); missing texts are English. Numbers are always written with a point.</summary>
/// <param name="assembly">The assembly that contains the resources.</param>
/// <param name="resource">The name of the resource without its extension, <c>Engraver.Core.Texts</c>; its second part is the project's name in the language
/// files.</param>
public sealed class TextCatalogue(Assembly assembly, string resource)
{
    private readonly ResourceManager _texts = new(resource, assembly);
    private readonly string _project = resource.Split('.')[1];

    /// <summary>A text without facts, or a template with its braces unchanged.</summary>
    /// <exception cref="MissingManifestResourceException">No text has that name: an error of the program.</exception>
    public string Get(string name) => Find(name) ?? throw new MissingManifestResourceException($"{resource} has no text '{name}'.");

    /// <summary>Null when no text has that name.</summary>
    public string? Find(string name)
    {
        if (PseudoLanguage.IsCurrent) return English(name) is { } english ? PseudoLanguage.Write(english) : null;
        return LanguageFile.For(CultureInfo.CurrentUICulture)?.Find(_project, name) ?? English(name);
    }

    /// <summary>The text with its facts at {0}, {1} ...; the part after a colon there is the format of a number.</summary>
    public string Get(string name, params object?[] facts) => string.Format(PseudoLanguage.IsCurrent ? PseudoLanguage.Facts : CultureInfo.InvariantCulture, Get(name), facts);

    /// <summary>A number with its noun: <c>NAME.One</c> for one, <c>NAME.Many</c> for every other number.</summary>
    public string Count(string name, int count) => Get(name + (count == 1 ? ".One" : ".Many"), count);

    private string? English(string name) => _texts.GetString(name, CultureInfo.InvariantCulture);

    /// <summary>A fact that another class inserts into texts, such as a name in a list; marked as one in the pseudo-language, otherwise unchanged.</summary>
    public static string Fact(string fact) => PseudoLanguage.IsCurrent ? PseudoLanguage.Mark(fact) : fact;
}
