using System.Diagnostics.CodeAnalysis;
using System.Resources;

namespace Engraver.Core.Languages;

/// <summary>The texts of one project, from its <c>Texts.resx</c>, in the current language. A project declares one class that derives from this one, in the
/// namespace of its resource: <c>class Wording : ProjectTexts&lt;Wording&gt;</c>.</summary>
/// <typeparam name="T">That class.</typeparam>
[SuppressMessage("Design", "CA1000", Justification = "Callers name the class of their project, without a type argument.")]
public abstract class ProjectTexts<T>
{
    private static readonly TextCatalogue s_texts = new(typeof(T).Assembly, typeof(T).Namespace + ".Texts");

    protected ProjectTexts()
    {
    }

    /// <exception cref="MissingManifestResourceException">No text has that name.</exception>
    public static string Get(string name) => s_texts.Get(name);

    /// <summary>The text with its facts at {0}, {1} ...</summary>
    public static string Get(string name, params object?[] facts) => s_texts.Get(name, facts);

    /// <summary>Null when no text has that name.</summary>
    public static string? Find(string name) => s_texts.Find(name);

    /// <summary>A number with its noun, from <c>NAME.One</c> and <c>NAME.Many</c>.</summary>
    public static string Count(string name, int count) => s_texts.Count(name, count);
}
