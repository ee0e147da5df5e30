namespace Engraver.Workbench.CommandLanguage;

/// <summary>The result of reading a typed value.</summary>
public abstract record ParsedInput<T>
{
    private ParsedInput()
    {
    }

    public sealed record Value(T Result) : ParsedInput<T>;

    /// <param name="Message">States which input is expected.</param>
    public sealed record Invalid(string Message) : ParsedInput<T>;
}
