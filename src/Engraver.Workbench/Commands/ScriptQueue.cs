using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>The scripts under way: one that another calls comes first, then the rest of the caller.</summary>
internal sealed class ScriptQueue
{
    /// <summary>A script that calls itself must end.</summary>
    private const int Deepest = 16;

    private readonly Stack<(string Path, IEnumerator<ScriptToken> Tokens)> _scripts = new();

    public bool IsRunnable => _scripts.Count > 0;

    /// <summary>Where the script under way stands.</summary>
    public string? Folder => _scripts.TryPeek(out var script) ? Path.GetDirectoryName(Path.GetFullPath(script.Path)) : null;

    public void Add(string path, string text)
    {
        if (_scripts.Count == Deepest) throw new CommandException(CommandFailure.Usage, $"Scripts call each other more than {Deepest} deep; does one call itself?");
        _scripts.Push((path, ScriptText.Read(text).GetEnumerator()));
    }

    /// <summary>The next input; null when all scripts are through.</summary>
    public ScriptInput? Next()
    {
        while (_scripts.TryPeek(out var script))
        {
            if (script.Tokens.MoveNext()) return new ScriptInput(script.Path, script.Tokens.Current);
            script.Tokens.Dispose();
            _scripts.Pop();
        }

        return null;
    }

    public void Clear()
    {
        while (_scripts.TryPop(out var script)) script.Tokens.Dispose();
    }
}
