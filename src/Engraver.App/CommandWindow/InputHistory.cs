namespace Engraver.App.CommandWindow;

/// <summary>Earlier inputs for the Up and Down keys. The text in the line before the first Up is kept and comes back after the last entry.</summary>
public sealed class InputHistory
{
    private const int MaxRecent = 10;
    private readonly List<string> _inputs = [];
    private int _index;
    private string _unfinished = "";

    /// <summary>The ten most recent distinct inputs, newest first, for a menu.</summary>
    public IReadOnlyList<string> Recent => [.. _inputs.AsEnumerable().Reverse().Distinct(StringComparer.OrdinalIgnoreCase).Take(MaxRecent)];

    public void Add(string input)
    {
        if (input.Length > 0 && (_inputs.Count == 0 || _inputs[^1] != input)) _inputs.Add(input);
        _index = _inputs.Count;
    }

    public string Back(string line)
    {
        if (_index == _inputs.Count) _unfinished = line;
        if (_index > 0) _index--;
        return _index < _inputs.Count ? _inputs[_index] : line;
    }

    public string Forward(string line)
    {
        if (_index >= _inputs.Count) return line;
        _index++;
        return _index == _inputs.Count ? _unfinished : _inputs[_index];
    }
}
