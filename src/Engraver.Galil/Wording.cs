using Engraver.Core.Languages;

namespace Engraver.Galil;

/// <summary>Every text of this project for people, from its <c>Texts.resx</c>, in the current language.</summary>
internal static class Wording
{
    private static readonly TextCatalogue s_texts = new(typeof(Wording).Assembly, "Engraver.Galil.Texts");

    public static string Get(string name) => s_texts.Get(name);

    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);

    /// <summary>A number with its noun, from <c>NAME.One</c> and <c>NAME.Many</c>.</summary>
    public static string Count(string name, int count) => s_texts.Count(name, count);
}
