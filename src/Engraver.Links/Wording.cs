using Engraver.Core.Languages;

namespace Engraver.Links;

/// <summary>Every text of this project for users, from its <c>Texts.resx</c>, in the current language.</summary>
internal static class Wording
{
    private static readonly TextCatalogue s_texts = new(typeof(Wording).Assembly, "Engraver.Links.Texts");

    public static string Get(string name) => s_texts.Get(name);

    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);
}
