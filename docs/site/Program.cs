using Engraver.Site;

// dotnet run --project docs/site [FOLDER]: README.md and docs/ as a static site in FOLDER, artifacts/site if none is given.
if (FindRoot() is not { } root)
{
    Console.Error.WriteLine("site: CncEngraver.sln was not found in this folder or above it.");
    return 2;
}

var output = Path.GetFullPath(args.Length > 0 ? args[0] : Path.Combine(root, "artifacts", "site"));
BuiltSite site;
try
{
    site = SiteBuilder.Build(root, output);
}
catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
{
    Console.Error.WriteLine($"site: {failure.Message}");
    return 1;
}

foreach (var error in site.Errors) Console.Error.WriteLine(error);
if (site.Errors.Count > 0)
{
    Console.Error.WriteLine(FormattableString.Invariant($"site: {site.Errors.Count} errors. Correct them, then build the site again."));
    return 1;
}

Console.WriteLine(FormattableString.Invariant($"site: {site.Pages.Count} pages in {output}. Open {Path.Combine(output, "index.html")} in a browser."));
return 0;

static string? FindRoot()
{
    var folder = new DirectoryInfo(Environment.CurrentDirectory);
    while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "CncEngraver.sln"))) folder = folder.Parent;
    return folder?.FullName;
}
