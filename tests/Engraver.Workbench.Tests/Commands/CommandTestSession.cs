using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>A command session in a temporary folder.</summary>
internal sealed class CommandTestSession : IAsyncDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-commands-");
    private readonly List<CommandMessage> _said = [];

    /// <param name="families">The controller families that the session knows; null for those of the program.</param>
    public CommandTestSession(MachineFamilies? families = null)
    {
        Session = new CommandSession(new CommandEnvironment { Families = families ?? MachineFamilies.Standard, Folder = _folder.FullName, RunJournalFolder = _folder.FullName, Journal = Journal, AliasFile = PathOf("my.pgp") }, CommandCatalog.Built());
        Session.MessageWritten += (_, message) => _said.Add(message);
    }

    public StringWriter Journal { get; } = new() { NewLine = "\n" };

    public CommandSession Session { get; }

    public DocumentState State => Session.Document.Current;

    /// <summary>All messages without echoes.</summary>
    public string Said => string.Join('\n', _said.Where(message => message.Kind != MessageKind.Echo).Select(message => message.Text));

    public string PathOf(string name) => Path.Combine(_folder.FullName, name);

    public static string Sample(string name) => Path.Combine(RepositoryFolder.Samples, name);

    /// <summary>A session with a drawing of one line (A1), one arc (A2), one circle (A3) and a square (A4), already open.</summary>
    public static CommandTestSession WithDrawing()
    {
        var talk = new CommandTestSession();
        var drawing = new DrawingBuilder().Line(0, 0, 10, 0).Arc(5, 5, 4, 350, 100).Circle(20, 5, 3).Square(30, 0, 8).Build();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        return talk;
    }

    /// <summary>Enters the inputs and returns the result of the last one.</summary>
    public async Task<InputResult> TypeAsync(params string[] inputs)
    {
        InputResult result = new InputResult.Done();
        foreach (var input in inputs) result = await Session.EnterAsync(input, CancellationToken.None);
        return result;
    }

    public async ValueTask DisposeAsync()
    {
        await Session.DisposeAsync();
        _folder.Delete(recursive: true);
    }
}
