namespace Engraver.Workbench.CommandLanguage;

/// <summary>What the operator answered to a prompt.</summary>
public abstract record Answer<T>
{
    private Answer()
    {
    }

    public sealed record Value(T Of) : Answer<T>;

    /// <param name="Option">The option's name as the prompt spells it.</param>
    public sealed record Chosen(string Option) : Answer<T>;

    /// <summary>Enter alone where that ends a list.</summary>
    public sealed record Ended : Answer<T>;
}
