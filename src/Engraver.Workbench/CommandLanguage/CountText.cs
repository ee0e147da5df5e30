namespace Engraver.Workbench.CommandLanguage;

/// <summary>A number with its noun: <c>1 error</c>, <c>2 errors</c>, <c>0 entities</c>.</summary>
public static class CountText
{
    /// <param name="noun">Which of the nouns in <c>Texts.resx</c>: <c>Error</c> for <c>Count.Error.One</c> and <c>Count.Error.Many</c>.</param>
    public static string Format(int count, string noun) => Wording.Count("Count." + noun, count);
}
