using Engraver.Workbench.Certificates;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Files;

public class CertifyCommandTests
{
    [Fact]
    public async Task The_certificate_stands_beside_the_drawing_and_arming_shows_it_until_a_setting_changes()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));
        await talk.TypeAsync("OPEN", "part.dxf", "CNCCONNECT", "sim:");
        await talk.TypeAsync("CNCARM", "Stream");
        Assert.Contains("The drawing has no certificate; CERTIFY", talk.Said, StringComparison.Ordinal);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CERTIFY", "Galil"));
        await talk.TypeAsync("CNCARM", "Stream");
        Assert.True(File.Exists(talk.PathOf("part.certificate.json")));
        Assert.Contains("The certificate is valid:", talk.Said, StringComparison.Ordinal);

        await talk.TypeAsync("CNCMAXERR", "0.002", "CNCARM", "Stream");
        Assert.Contains("is for another job; changed: CNCMAXERR", talk.Said, StringComparison.Ordinal);
    }

    /// <summary>As `certify --dialect grbl` of the console: the same file, read back by the rules of grbl.</summary>
    [Theory]
    [InlineData("gcode-grbl", "grbl", "part.gcode-grbl.certificate.json")]
    [InlineData("R", "grbl", "part.gcode-grbl.certificate.json")]
    [InlineData("gcode", null, "part.gcode.certificate.json")]
    public async Task A_kind_of_controller_is_chosen_with_the_target(string typed, string? dialect, string file)
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("OPEN", "part.dxf", "CERTIFY", typed));
        var program = CertificateFile.Read(talk.PathOf(file)).Certificate!.Program;
        Assert.Equal(("gcode", dialect), (program.Target, program.Dialect));
    }

    [Fact]
    public async Task Edits_that_no_file_holds_are_not_certified()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));
        await talk.TypeAsync("OPEN", "part.dxf", "MOVE", "ALL", "", "0,0", "1,0");

        Assert.Contains("changes that are not in its file", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CERTIFY")).Message, StringComparison.Ordinal);
        Assert.False(File.Exists(talk.PathOf("part.certificate.json")));
    }

    [Fact]
    public async Task What_the_window_draws_follows_the_document()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));
        await talk.TypeAsync("OPEN", "part.dxf");
        var seen = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        talk.Session.Certificates.Changed += (_, _) => seen.TrySetResult();
        var derived = await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);
        await seen.Task.WaitAsync(TimeSpan.FromSeconds(60));
        Assert.Equal(CertificateState.None, talk.Session.Certificates.StatusOf(derived.Job!)!.State);

        await talk.TypeAsync("CERTIFY", "Galil");
        Assert.Equal(CertificateState.Stands, talk.Session.Certificates.StatusOf(derived.Job!)!.State);
        await talk.TypeAsync("CNCMAXERR", "0.002");
        var other = await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);
        Assert.NotEqual(CertificateState.Stands, talk.Session.Certificates.StatusOf(other.Job!)?.State);
    }
}
