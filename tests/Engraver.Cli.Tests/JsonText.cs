using System.Text.Json;

namespace Engraver.Cli.Tests;

/// <summary>The one JSON object that a run printed.</summary>
internal static class JsonText
{
    /// <summary>Throws if standard output contains anything but one object.</summary>
    public static JsonElement Of(CliRun run) => JsonDocument.Parse(run.Out).RootElement;
}
