using System.Resources;
using Engraver.Core.Languages;

namespace Engraver.App.Texts;

/// <summary>Every text of the desktop, from <c>Texts.resx</c> or, in another language, from the file of that language. Numbers in them always have a
/// decimal point.</summary>
public static class Text
{
    private static readonly TextCatalogue s_texts = new(typeof(Text).Assembly, "Engraver.App.Texts.Texts");

    /// <exception cref="MissingManifestResourceException">There is no text of that name.</exception>
    public static string Get(string name) => s_texts.Get(name);

    /// <summary>Null if there is no text of that name.</summary>
    public static string? Find(string name) => s_texts.Find(name);

    /// <summary>A number with its noun: <c>NAME.One</c> for one, <c>NAME.Many</c> for every other number.</summary>
    public static string Count(string name, int count) => s_texts.Count(name, count);

    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);
}
