using Engraver.Core.Languages;

namespace Engraver.Workbench;

/// <summary>The texts of this project from its <c>Texts.resx</c>, in the current language.</summary>
internal static class Wording
{
    private static readonly TextCatalogue s_texts = new(typeof(Wording).Assembly, "Engraver.Workbench.Texts");

    public static string Get(string name) => s_texts.Get(name);

    public static string? Find(string name) => s_texts.Find(name);

    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);

    /// <summary>A number with its noun, from <c>NAME.One</c> and <c>NAME.Many</c>.</summary>
    public static string Count(string name, int count) => s_texts.Count(name, count);
}
