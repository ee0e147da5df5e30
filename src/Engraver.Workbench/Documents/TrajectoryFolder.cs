using System.Text;
using System.Text.Json;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Documents;

/// <summary>A folder of trajectories: a file for each, and <see cref="ListName"/>, which lists them in order with their start points, because XPS formats are
/// relative to these.</summary>
public static class TrajectoryFolder
{
    /// <summary>Name of the list file. It is written last, so that it lists only existing files.</summary>
    public const string ListName = "trajectories.json";

    /// <summary>Writes each file atomically. Other files in the folder are kept.</summary>
    /// <exception cref="IOException">The path cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the path is denied.</exception>
    public static void Write(string folder, IReadOnlyList<NamedTrajectory> trajectories, TrajectoryFormat format)
    {
        ArgumentNullException.ThrowIfNull(trajectories);
        if (!Directory.Exists(folder)) Directory.CreateDirectory(folder);
        foreach (var trajectory in trajectories) OutputFile.Write(Path.Combine(folder, trajectory.FileName), writer => writer.Write(trajectory.File.Text));
        OutputFile.Write(Path.Combine(folder, ListName), writer => writer.Write(List(trajectories, format) + "\n"));
    }

    private static string List(IReadOnlyList<NamedTrajectory> trajectories, TrajectoryFormat format)
    {
        using var memory = new MemoryStream();
        using (var json = new Utf8JsonWriter(memory, new JsonWriterOptions { Indented = true, NewLine = "\n" }))
        {
            json.WriteStartObject();
            json.WriteNumber("version", 1);
            json.WriteString("format", TrajectoryFormatName.Of(format));
            json.WriteStartArray("trajectories");
            foreach (var trajectory in trajectories) Write(json, trajectory);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(memory.ToArray());
    }

    private static void Write(Utf8JsonWriter json, NamedTrajectory trajectory)
    {
        var file = trajectory.File;
        json.WriteStartObject();
        json.WriteString("file", trajectory.FileName);
        json.WriteString("source", trajectory.Source);
        json.WriteStartObject("start");
        json.WriteNumber("x", file.Start.X);
        json.WriteNumber("y", file.Start.Y);
        json.WriteNumber("z", file.Z);
        json.WriteEndObject();
        json.WriteNumber("points", file.Points);
        json.WriteNumber("verifiedBound", file.VerifiedBound);
        json.WriteNumber("length", file.Length);
        json.WriteBoolean("closed", file.Closed);
        json.WriteEndObject();
    }
}
