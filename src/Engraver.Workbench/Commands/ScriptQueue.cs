using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>The running scripts: a called script runs first, then the rest of its caller.</summary>
internal sealed class ScriptQueue
{
    /// <summary>Maximum nesting of scripts, which ends endless recursion.</summary>
    private const int MaxDepth = 16;

    private readonly Stack<(string Path, IEnumerator<ScriptToken> Tokens)> _scripts = new();
    private readonly Lock _guard = new(); // Esc clears it from another thread.

    public bool IsRunnable
    {
        get
        {
            lock (_guard) return _scripts.Count > 0;
        }
    }

    /// <summary>Path of a file in the working folder, otherwise beside the running script; if neither exists, the path in the working folder.</summary>
    public string ResolveInputPath(string folder, string name)
    {
        var here = Path.Combine(folder, name);
        if (File.Exists(here) || !TryPeek(out var script) || Path.GetDirectoryName(Path.GetFullPath(script.Path)) is not { } own) return here;
        var beside = Path.Combine(own, name);
        return File.Exists(beside) ? beside : here;
    }

    public void Add(string path, string text)
    {
        lock (_guard) Push(path, text);
    }

    private void Push(string path, string text)
    {
        if (_scripts.Count == MaxDepth) throw new CommandException(CommandFailure.Usage, Wording.Get("ScriptQueue.TooDeep", MaxDepth));
        _scripts.Push((path, ScriptText.Read(text).GetEnumerator()));
    }

    private bool TryPeek(out (string Path, IEnumerator<ScriptToken> Tokens) script)
    {
        lock (_guard) return _scripts.TryPeek(out script);
    }

    /// <summary>The next input; null if all scripts have ended.</summary>
    public ScriptInput? Next()
    {
        lock (_guard)
        {
            while (_scripts.TryPeek(out var script))
            {
                if (script.Tokens.MoveNext()) return new ScriptInput(script.Path, script.Tokens.Current);
                script.Tokens.Dispose();
                _scripts.Pop();
            }

            return null;
        }
    }

    public void Clear()
    {
        lock (_guard)
        {
            while (_scripts.TryPop(out var script)) script.Tokens.Dispose();
        }
    }
}

/// <summary>An input of a script with its location, for error messages.</summary>
internal sealed record ScriptInput(string Path, ScriptToken Token)
{
    /// <summary>Adds file and line of the input to the message of a failure; other results are unchanged.</summary>
    public InputResult WithLocation(InputResult result) => result switch
    {
        InputResult.Failed failed => failed with { Message = AddLocation(failed.Message) },
        InputResult.NotAccepted unclear => new InputResult.Failed(CommandFailure.Usage, AddLocation(unclear.Message)),
        _ => result,
    };

    private string AddLocation(string sentence) => Wording.Get("ScriptQueue.Place", Path, Token.Line, Token.Text, sentence);
}
