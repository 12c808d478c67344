-- One kind of client for wrk: each pauses between requests, and what they saw is printed as JSON at the end.
--
-- CLIENT  what they do: read or submit
-- STUDY   a study to look at
-- FILE    the document to submit
-- PAUSE   mean pause of each client, ms

local kind, study, pause = os.getenv("CLIENT"), os.getenv("STUDY"), tonumber(os.getenv("PAUSE"))
local threads = {}

function setup(thread)
    table.insert(threads, thread)
end

function init()
    math.randomseed(os.time())
    accepted, refused, read = 0, 0, 0
    if kind == "submit" then
        local file = io.open(os.getenv("FILE"))
        document = file:read("*a")
        file:close()
    end
end

-- From nothing to twice the mean, so that clients don't march in step.
function delay()
    return math.random(0, 2 * pause)
end

function request()
    if kind == "submit" then
        -- Below everything that is measured: these studies wait.
        return wrk.format("POST", "/v1/studies?priority=-100", { ["Content-Type"] = "application/json" }, document)
    end
    read = read + 1
    local paths = { "/v1/studies?limit=50", "/v1/studies/" .. study, "/v1/studies/" .. study .. "/evaluations", "/v1/presets" }
    return wrk.format("GET", paths[1 + read % #paths])
end

function response(status)
    if status == 200 or status == 202 then
        accepted = accepted + 1
    else
        refused = refused + 1
    end
end

function done(summary, latency)
    local answered, declined = 0, 0
    for _, thread in ipairs(threads) do
        answered = answered + thread:get("accepted")
        declined = declined + thread:get("refused")
    end
    local errors = summary.errors.connect + summary.errors.read + summary.errors.write + summary.errors.timeout
    print(string.format('{"answered": %d, "refused": %d, "broken": %d, "p50_ms": %.3f, "p99_ms": %.3f, "max_ms": %.3f}',
        answered, declined, errors, latency:percentile(50) / 1000, latency:percentile(99) / 1000, latency.max / 1000))
end
