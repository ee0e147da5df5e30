namespace Engraver.Simulator.Language;

/// <summary>The last statements of the hosts, already read: one that polls asks the same thing thousands of times.</summary>
internal sealed class StatementCache
{
    private const int Places = 64;
    private readonly (string Source, Statement Statement)[] _known = new (string, Statement)[Places];

    public Statement Read(ReadOnlySpan<char> source)
    {
        ref var place = ref _known[(uint)string.GetHashCode(source) % Places];
        if (place.Source is { } known && source.SequenceEqual(known)) return place.Statement;
        place = (source.ToString(), Statement.Parse(source));
        return place.Statement;
    }
}
