namespace Engraver.Workbench.CommandLanguage;

/// <summary>What came of reading a typed value.</summary>
public abstract record Reading<T>
{
    private Reading()
    {
    }

    public sealed record Value(T Of) : Reading<T>;

    /// <param name="Sentence">What is wanted instead.</param>
    public sealed record Wrong(string Sentence) : Reading<T>;
}
