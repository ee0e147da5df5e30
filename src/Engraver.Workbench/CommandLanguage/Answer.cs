namespace Engraver.Workbench.CommandLanguage;

/// <summary>What the operator answered to a prompt.</summary>
public abstract record Answer<T>
{
    private Answer()
    {
    }

    public sealed record Value(T Result) : Answer<T>;

    /// <param name="Option">The option's name as the prompt spells it.</param>
    public sealed record SelectedOption(string Option) : Answer<T>;

    /// <summary>Enter alone, which ends a list.</summary>
    public sealed record EndOfList : Answer<T>;
}
