using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>Variables and arrays (galil-dmc.md E): 254 variables, 30 arrays with 8000 elements together, names up to 8 characters.</summary>
internal sealed class VariableStore
{
    public const int MaximumVariables = 254;
    public const int MaximumArrays = 30;
    public const int MaximumElements = MemorySizes.ArrayElements;
    private const int LongestName = 8;

    private readonly Dictionary<string, FixedPoint>.AlternateLookup<ReadOnlySpan<char>> _variables;
    private readonly Dictionary<string, FixedPoint[]>.AlternateLookup<ReadOnlySpan<char>> _arrays;

    public VariableStore()
    {
        _variables = Variables.GetAlternateLookup<ReadOnlySpan<char>>();
        _arrays = Arrays.GetAlternateLookup<ReadOnlySpan<char>>();
    }

    public Dictionary<string, FixedPoint> Variables { get; } = new(StringComparer.Ordinal);

    public Dictionary<string, FixedPoint[]> Arrays { get; } = new(StringComparer.Ordinal);

    public int ElementsLeft => MaximumElements - Arrays.Values.Sum(a => a.Length);

    public FixedPoint Read(ReadOnlySpan<char> name) =>
        _variables.TryGetValue(name, out var value) ? value : throw new CommandRefusedException(Tc.VariableError);

    public void Write(ReadOnlySpan<char> name, FixedPoint value)
    {
        if (name.Length > LongestName || Keywords.IsReserved(name)) throw new CommandRefusedException(Tc.VariableError);
        if (Variables.Count >= MaximumVariables && !_variables.ContainsKey(name)) throw new CommandRefusedException(Tc.TooManyNames);
        _variables[name] = value;
    }

    public FixedPoint[] ArrayNamed(ReadOnlySpan<char> name, int codeWhenMissing = Tc.BadFunction) =>
        _arrays.TryGetValue(name, out var array) ? array : throw new CommandRefusedException(codeWhenMissing);

    public void Dimension(string name, int length)
    {
        if (name.Length is 0 or > LongestName) throw new CommandRefusedException(Tc.VariableError);
        if (length < 1) throw new CommandRefusedException(Tc.BadIndex);
        var freed = Arrays.TryGetValue(name, out var old) ? old.Length : 0;
        if (old is null && Arrays.Count >= MaximumArrays) throw new CommandRefusedException(Tc.TooManyNames);
        if (length > ElementsLeft + freed) throw new CommandRefusedException(Tc.ArraySpaceFull);
        Arrays[name] = new FixedPoint[length];
    }

    public void Clear()
    {
        Variables.Clear();
        Arrays.Clear();
    }
}
